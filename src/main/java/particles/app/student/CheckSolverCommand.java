package particles.app.student;

import deSolvers.DESolver;
import deSolvers.catalog.SolverCatalog;
import java.util.ArrayList;
import java.util.List;
import java.util.NoSuchElementException;
import java.util.Set;
import java.util.function.Supplier;
import particles.app.student.Check.Checked;
import particles.output.report.Picture;
import particles.spec.messages.Wording;
import particles.teaching.Finding;
import particles.teaching.Finding.Kind;
import particles.teaching.StudentFailure;
import particles.teaching.figures.SolverFigures;
import particles.teaching.solvers.SolverCheck;
import particles.teaching.solvers.SolverVerdict;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** {@code gradle checkSolver -Psolver=exercises.HeunSolver}: identifies a solver's method and finds its mistakes. */
@Command(name = CheckSolverCommand.NAME,
        description = "Checks a solver: which method it is, and what is wrong with it.")
public final class CheckSolverCommand extends CheckCommand {
    /** The name of the command. */
    public static final String NAME = "checkSolver";

    @Option(names = "--solver", paramLabel = "NAME", required = true,
            description = "A solver's name, or the class of your own.")
    private String solver;

    @Option(names = "--method", paramLabel = "NAME",
            description = "The method that it has to be, such as heun (default: the one that its name declares).")
    private String method = AskedMethods.ANY;

    @Override
    Check check() {
        if (!AskedMethods.NAMES.contains(method)) {
            throw wrong("method", Wording.unknown("method", method, AskedMethods.NAMES, List.of()));
        }
        return new Check(NAME, solver, method);
    }

    /** Checks the solver of this name or class, which has to be a method; runs its code. */
    static Checked checked(String subject, String method) {
        String full = SolverCatalog.names().contains(subject) || subject.contains(".") ? subject
                : "exercises." + subject;
        Supplier<DESolver> maker = () -> SolverCatalog.create(full);
        String name;
        try {
            name = maker.get().getClass().getSimpleName();
        } catch (NoSuchElementException e) {
            return new Checked(subject, new NoSuchElementException("no class is called '" + full + "'; classes in the"
                    + " folder of exercises: " + StudentLoader.installed().keySet() + "; known solvers: "
                    + SolverCatalog.names(), e));
        } catch (IllegalArgumentException e) {
            return new Checked(subject, e);
        }
        SolverVerdict verdict = AskedMethods.check(maker, name, method);
        List<Finding> findings = new ArrayList<>(verdict.findings());
        boolean right = verdict.wrong().isEmpty();
        if (right && PlainRuns.differ(run -> SolverCheck.check(() -> {
            run.run();
            throw new IllegalStateException();          // the check itself is not wanted
        }, name), before -> PlainRuns.solver(maker, before))) {
            findings.add(new Finding(Kind.FAILURE,
                    "outside this check, or after many steps, its steps differ from those in this check"));
        }
        if (findings.stream().map(Finding::kind).anyMatch(Set.of(Kind.FAILURE, Kind.UNWRITTEN)::contains)) {
            return new Checked(name, verdict.identity(), findings);
        }
        SolverFigures figures;
        try {
            figures = SolverFigures.of(SolverCatalog.names().contains(subject) ? subject : name, maker, verdict);
        } catch (RuntimeException e) {                  // of the class itself; still report the findings
            if (right) {                                // otherwise it follows from a mistake already reported
                findings.add(new Finding(Kind.FAILURE, "while it was measured on springs: "
                        + StudentFailure.describe(e)));
            }
            return new Checked(name, verdict.identity(), findings);
        }
        List<Picture> pictures = new ArrayList<>();
        pictures.add(Picture.of("order",
                "The error after two seconds of x'' = -4x + 3 cos t; the slope is the order.",
                figures.order()));
        figures.region().ifPresent(region -> pictures.add(Picture.of("region",
                "Stability region, measured: every mode of a system has to lie in it, at deltaT times its eigenvalue"
                        + " lambda.", region)));
        pictures.add(Picture.of("energy", "The energy of an undamped spring, which should stay constant.",
                figures.energy()));
        return new Checked(name, verdict.identity(), findings, pictures, List.of(figures.facts()));
    }
}
