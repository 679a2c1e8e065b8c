package particles.app.student;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import particles.app.cli.ProgramCommand;
import particles.spec.messages.InvalidInputException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/**
 * {@code gradle newSolver -Pclass=HeunSolver} and {@code gradle newEffect -Pclass=MyGravity}: writes the skeleton of a
 * class, which compiles and does nothing yet.
 */
public abstract class NewClassCommand extends ProgramCommand {
    @Option(names = "--class", paramLabel = "NAME", required = true,
            description = "The name of the class, such as HeunSolver or MyForce.")
    private String className;

    private final Path folder;
    private final String skeleton;
    private final String hints;

    /**
     * @param folder   the folder of students' classes
     * @param skeleton the text of the class, with NAME for its name
     * @param hints    how to check the class, and how to use it, likewise
     */
    NewClassCommand(Path folder, String skeleton, String hints) {
        this.folder = folder;
        this.skeleton = skeleton;
        this.hints = hints;
    }

    @Override
    public final void run(PrintWriter out) throws IOException {
        String name = className.replaceFirst("^exercises[.]", "");
        if (!name.matches("[A-Z]\\w*")) {
            throw wrong("class", "'" + name + "' is not a class name; use a capital, then letters and digits");
        }
        Path file = folder.resolve(name + ".java");
        Files.createDirectories(folder);
        try {
            Files.writeString(file, skeleton.replace("NAME", name), StandardOpenOption.CREATE_NEW);
        } catch (FileAlreadyExistsException e) {
            throw new InvalidInputException(file
                    + " exists already and was not changed; choose another name or remove it first");
        }
        out.println("written: " + file);
        out.print(hints.replace("NAME", name));
    }

    /** {@code gradle newSolver}: writes the skeleton of a solver, as on the slides. */
    @Command(name = "newSolver", description = "Writes the skeleton of a solver of your own.")
    public static final class NewSolver extends NewClassCommand {
        private static final String SKELETON = """
                package exercises;

                import deSolvers.DESolver;
                import deSolvers.DEStateSource;

                /** My own solver. To check it: gradle checkSolver -Psolver=exercises.NAME */
                public class NAME extends DESolver {

                    @Override
                    public void stepState(DEStateSource source, double deltaT) {
                        double[] state = new double[source.getStateSize()];
                        double[] dSdt = new double[state.length];
                        source.getState(state);             // s at time t: x, y, z, vx, vy, vz of each particle
                        source.getStateDerivative(dSdt);    // its derivative at (s, t)

                        // 1. perhaps further derivatives, each at a trial state and its own time:
                        //    source.setState(trial); source.incTime(deltaT / 2); source.getStateDerivative(...)
                        // 2. new s = s + deltaT * a mean of the derivatives; the weights add up to 1
                        // 3. source.setState(new s); all calls of source.incTime add up to deltaT
                    }
                }
                """;

        /** @param folder the folder of students' classes */
        public NewSolver(Path folder) {
            super(folder, SKELETON, """
                    to check it: gradle checkSolver -Psolver=exercises.NAME
                    to use it: gradle run -Pscene=2 -Psolver=exercises.NAME
                    """);
        }
    }

    /** {@code gradle newEffect}: writes the skeleton of a force law, whose keys can be used in a scene. */
    @Command(name = "newEffect", description = "Writes the skeleton of a force law of your own.")
    public static final class NewEffect extends NewClassCommand {
        /** The text of the class, with NAME for its name. */
        public static final String SKELETON = """
                package exercises;

                import particles.effects.EffectContext;
                import particles.effects.EffectKind;
                import particles.law.ParticleForce;
                import particles.law.Particles;
                import particles.law.Vector3;
                import particles.spec.Key;
                import particles.spec.NumberType;
                import particles.spec.Values;

                /** My own force law. To check it: gradle checkEffect -Peffect=exercises.NAME */
                public class NAME extends ParticleForce {
                    private final double strength;

                    public NAME(Particles particles, double strength) {
                        super(particles);
                        this.strength = strength;
                    }

                    @Override
                    protected Vector3 getForce(Vector3 position, Vector3 velocity, double mass, double time) {
                        // the total force on the particle, in newton, such as: return position.times(-strength);
                        return Vector3.ZERO;
                    }

                    // A law with a potential energy, in joule, has these, too:
                    // @Override public java.util.Set<Trait> getTraits() {
                    //     return java.util.Set.of(Trait.CONSERVATIVE);
                    // }
                    // @Override public boolean dependsOnVelocity() { return false; }
                    // @Override protected double getPotentialEnergy(Vector3 position, double mass, double time) {
                    //     return 0.5 * strength * position.dot(position);
                    // }

                    /** In a scene: - exercises.NAME: {strength: 2} */
                    public static final class Keys extends EffectKind {
                        private static final Key<Double> STRENGTH = NumberType.any("N/m").required("strength",
                                "The force for each metre (N/m).");

                        public Keys() {
                            super("exercises.NAME", "My own force.", STRENGTH);
                        }

                        @Override
                        public void build(Values values, EffectContext scene) {
                            scene.add(new NAME(scene.particles(), values.get(STRENGTH)));
                        }
                    }
                }
                """;

        /** @param folder the folder of students' classes */
        public NewEffect(Path folder) {
            super(folder, SKELETON, """
                    to check it: gradle checkEffect -Peffect=exercises.NAME
                    to use it: in a scene, under effects:  - exercises.NAME: {strength: 2}
                    """);
        }
    }
}
