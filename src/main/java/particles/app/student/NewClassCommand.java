package particles.app.student;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Locale;
import java.util.Optional;
import particles.app.cli.ProgramCommand;
import particles.app.student.SolverSkeleton.Base;
import particles.app.student.SolverSkeleton.Example;
import particles.spec.messages.InvalidInputException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/**
 * {@code gradle newSolver -Pclass=HeunSolver} and {@code gradle newEffect -Pclass=MyGravity}: writes the skeleton of a
 * class.
 */
public abstract class NewClassCommand extends ProgramCommand {
    @Option(names = "--class", paramLabel = "NAME",
            description = "The name of the class, such as HeunSolver or MyForce.")
    private Optional<String> className;

    private final Path folder;
    private final String check;
    private final String use;

    /**
     * @param folder the folder of students' classes
     * @param check  the command that checks such a class, with %s for its full name
     * @param use    the way to use it, likewise
     */
    NewClassCommand(Path folder, String check, String use) {
        this.folder = folder;
        this.check = check;
        this.use = use;
    }

    /** @return the class's name if none is given; empty if one has to be */
    Optional<String> usualName() {
        return Optional.empty();
    }

    /** @return the class's text */
    abstract String text(String name);

    @Override
    public final void run(PrintWriter out) throws IOException {
        String name = className.or(this::usualName).orElse("").replaceFirst("^exercises[.]", "");
        if (!name.matches("[A-Z]\\w*")) {
            throw wrong("class", "'" + name + "' is not a class name; use a capital, then letters and digits");
        }
        Path file = folder.resolve(name + ".java");
        Files.createDirectories(folder);
        try {
            Files.writeString(file, text(name), StandardOpenOption.CREATE_NEW);
        } catch (FileAlreadyExistsException e) {
            throw new InvalidInputException(file
                    + " exists already and was not changed; choose another name or remove it first");
        }
        out.println("written: " + file);
        out.println("to check it: " + check.formatted("exercises." + name));
        out.println("to use it: " + use.formatted("exercises." + name));
    }

    /** {@code gradle newSolver}: writes the skeleton of a solver. */
    @Command(name = "newSolver", description = "Writes the skeleton of a solver of your own.")
    public static final class NewSolver extends NewClassCommand {
        @Option(names = "--from", paramLabel = "CLASS", description = "What it extends: DESolver, as on the slides, or"
                + " FixedStepSolver, which has helpers for formulas.")
        private Base from = Base.DESOLVER;

        @Option(names = "--example", paramLabel = "METHOD",
                description = "Writes a whole small solver to compare with: euler, heun or midpoint.")
        private Optional<Example> example;

        /** Creates the command; see {@link NewClassCommand}. */
        public NewSolver(Path folder) {
            super(folder, "gradle checkSolver -Psolver=%s", "gradle run -Pscene=2 -Psolver=%s");
        }

        @Override
        Optional<String> usualName() {
            return example.map(method -> method.name().charAt(0) + method.name().substring(1).toLowerCase(Locale.ROOT)
                    + "Example");
        }

        @Override
        String text(String name) {
            return example.map(method -> SolverSkeleton.example(name, method)).orElseGet(() ->
                    SolverSkeleton.solver(name, from));
        }
    }

    /** {@code gradle newEffect}: writes the skeleton of a force law. */
    @Command(name = "newEffect", description = "Writes the skeleton of a force law of your own.")
    public static final class NewEffect extends NewClassCommand {
        @Option(names = "--conservative", paramLabel = "true|false", arity = "0..1",
                description = "Whether it has a potential energy.")
        private boolean conservative;

        /** Creates the command; see {@link NewClassCommand}. */
        public NewEffect(Path folder) {
            super(folder, "gradle checkEffect -Peffect=%s", "in a scene, under effects:  - %s: {strength: 2}");
        }

        @Override
        String text(String name) {
            return EffectSkeleton.effect(name, conservative);
        }
    }
}
