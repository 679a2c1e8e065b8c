package particles.app.student;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Texts.assertHas;
import static particles.Texts.assertStarts;

import deSolvers.DESolver;
import deSolvers.DEStateSource;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import particles.app.cli.ExitCode;
import particles.app.cli.OptionStyle;
import particles.app.cli.Screen;
import particles.teaching.GuardedRun;
import particles.teaching.figures.SolverFigures;
import particles.teaching.solvers.SolverCheck;
import particles.teaching.solvers.SolverVerdict;

/** The check of a solver through the program: its screen, its report, and a class that ends the program. */
class CheckSolverCommandTest {

    /** Euler without the clock. */
    public static final class NoClock extends DESolver {
        @Override
        public void stepState(DEStateSource source, double deltaT) {
            double[] state = new double[source.getStateSize()];
            double[] dSdt = new double[source.getStateSize()];
            source.getState(state);
            source.getStateDerivative(dSdt);
            for (int i = 0; i < state.length; i++) {
                state[i] += deltaT * dSdt[i];
            }
            source.setState(state);
        }
    }

    /** Euler that crashes at one deltaT, after all of the contract was looked at. */
    public static final class Crashes extends DESolver {
        @Override
        public void stepState(DEStateSource source, double deltaT) {
            if (deltaT == 1) {
                throw new IndexOutOfBoundsException("at 1");
            }
            new deSolvers.EulerSolver().stepState(source, deltaT);
        }
    }

    /** Euler that thinks for 60 microseconds. */
    public static final class Thinks extends DESolver {
        @Override
        public void stepState(DEStateSource source, double deltaT) {
            long begun = System.nanoTime();
            while (System.nanoTime() - begun < 60_000) {
                Thread.onSpinWait();
            }
            new deSolvers.EulerSolver().stepState(source, deltaT);
        }
    }

    /** Euler that refuses steps back and long ones. */
    public static final class Refuses extends DESolver {
        @Override
        public void stepState(DEStateSource source, double deltaT) {
            if (deltaT <= 0 || deltaT > 0.5) {
                throw new IllegalArgumentException("deltaT has to be above 0 and at most 0.5 s, and is " + deltaT);
            }
            new deSolvers.EulerSolver().stepState(source, deltaT);
        }
    }

    /** Backward Euler by an iteration that converges for short steps only. */
    public static final class Iterates extends DESolver {
        @Override
        public void stepState(DEStateSource source, double deltaT) {
            double[] start = new double[source.getStateSize()];
            source.getState(start);
            source.incTime(deltaT);
            double[] next = start;
            for (int round = 0; round < 200; round++) {
                source.setState(next);
                double[] dSdt = new double[next.length];
                source.getStateDerivative(dSdt);
                double[] better = start.clone();
                double change = 0;
                for (int i = 0; i < better.length; i++) {
                    better[i] += deltaT * dSdt[i];
                    change = Math.max(change, Math.abs(better[i] - next[i]));
                }
                next = better;
                if (change < 1e-12) {
                    source.setState(next);
                    return;
                }
            }
            throw new IllegalStateException("it does not converge: use a shorter deltaT than " + deltaT);
        }
    }

    /** Ends the process and leaves no time for a report. */
    public static final class Halts extends DESolver {
        @Override
        public void stepState(DEStateSource source, double deltaT) {
            Runtime.getRuntime().halt(0);
        }
    }

    /** Ends everything. */
    public static final class Exits extends DESolver {
        @Override
        public void stepState(DEStateSource source, double deltaT) {
            System.exit(0);
        }
    }

    /** Never ends. */
    public static final class Loops extends DESolver {
        @Override
        public void stepState(DEStateSource source, double deltaT) {
            double t = 0;
            while (t < source.getTime() + 1) {
                t += 0 * deltaT;
            }
        }
    }

    /** Calls itself. */
    public static final class Overflows extends DESolver {
        @Override
        @SuppressWarnings("InfiniteRecursion")
        public void stepState(DEStateSource source, double deltaT) {
            stepState(source, deltaT);
        }
    }

    /** Asks for more than there is. */
    public static final class Hoards extends DESolver {
        private final java.util.List<double[]> kept = new java.util.ArrayList<>();

        @Override
        public void stepState(DEStateSource source, double deltaT) {
            while (source.getTime() < 1) {
                kept.add(new double[100_000_000]);
            }
        }
    }

    private static Check check(String solver) {
        return new Check(CheckSolverCommand.NAME, solver, AskedMethods.ANY);
    }

    private static String here(ExitCode expected, String solver, Path folder) {
        return Checks.here(expected, check(solver), folder);
    }

    @Test
    void aRightSolverGetsItsNameNumbersAndPictures(@TempDir Path folder) throws IOException {
        String screen = here(ExitCode.DONE, "midpoint", folder);
        assertStarts(screen, "MidpointSolver: right. This is the midpoint method.");
        assertTrue(screen.lines().count() <= 12, screen);
        String report = Files.readString(folder.resolve("report/checkSolver.md"));
        for (String picture : List.of("order.png", "region.png", "energy.png")) {
            assertHas(report, "(" + picture + ")");
            assertTrue(Files.size(folder.resolve("report").resolve(picture)) > 1000, picture);
        }
    }

    @Test
    void aWrongSolverGetsItsMistakeAndAnExitCode(@TempDir Path folder) throws IOException {
        String screen = here(ExitCode.BAD_INPUT, NoClock.class.getName(), folder);
        String mistake = "after step 1 of deltaT = 1/32 s the clock is off by -0.03125 s: incTime has to move it to t +"
                + " deltaT";
        assertTrue(screen.lines().anyMatch(("WRONG, time: " + mistake)::equals), screen);
        assertStarts(screen, "NoClock: wrong. ");
        assertHas(Files.readString(folder.resolve("report/checkSolver.md")), "- WRONG, time: " + mistake);
    }

    @Test
    void theMethodAskedForReachesTheCheck(@TempDir Path folder) {
        String screen = Screen.of(ExitCode.BAD_INPUT, List.of(new CheckSolverCommand()), OptionStyle.SHELL,
                "checkSolver", "--solver=" + Refuses.class.getName(), "--method=rk4", "--out=" + folder);
        assertHas(screen, "PROMISE, name: this is the Euler method and not RK4, the classical Runge-Kutta method");
    }

    @Test
    void anExceptionWhileItIsMeasuredLosesNothingThatWasFoundOut(@TempDir Path folder) throws IOException {
        String screen = here(ExitCode.BAD_INPUT, Crashes.class.getName(), folder);
        assertStarts(screen, "Crashes: wrong. This is the Euler method.");
        String mistake = "while it was measured on springs: java.lang.IndexOutOfBoundsException: at 1, in Crashes.";
        assertHas(screen, "failure: " + mistake);
        assertHas(Files.readString(folder.resolve("report/checkSolver.md")), "- WRONG, failure: " + mistake);
    }

    @Test
    void aSolverThatRefusesSomeStepsIsRight(@TempDir Path folder) throws IOException {
        String screen = here(ExitCode.DONE, Refuses.class.getName(), folder);
        assertStarts(screen, "Refuses: right. This is the Euler method.");
        String report = Files.readString(folder.resolve("report/checkSolver.md"));
        assertHas(report, "a step of 1 s is refused");
    }

    @Test
    void refusedStepsAreNoPartOfTheStabilityRegion(@TempDir Path folder) throws IOException {
        String screen = here(ExitCode.DONE, Iterates.class.getName(), folder);
        assertStarts(screen, "Iterates: right. This is backward Euler.");
        String report = Files.readString(folder.resolve("report/checkSolver.md"));
        assertHas(report, "(region.png)", "a step of 1 s is refused",
                "damped: 0.8710, undamped: 0.8710");
    }

    /** Each has 10,000 steps or more, of 0.6 s or more in all, and an endless loop is told after 0.2 s. */
    @Test
    void manyCostlyStepsAreNoEndlessLoop() {
        SolverVerdict verdict = SolverCheck.check(Thinks::new, "Thinks");
        for (Callable<?> part : List.<Callable<?>>of(() -> SolverCheck.check(Thinks::new, "Thinks").wrong().isEmpty(),
                () -> SolverFigures.of("Thinks", Thinks::new, verdict).region().isPresent(),
                () -> !PlainRuns.differ(Runnable::run, before -> PlainRuns.solver(Thinks::new, before)))) {
            assertEquals("Outcome[value=Optional[true], failure=Optional.empty]", new GuardedRun(0.2).run(part)
                    .toString());
        }
    }

    @Test
    void aCheckThatWasEndedLeavesNoOlderReport(@TempDir Path folder) throws IOException {
        here(ExitCode.DONE, "euler", folder);
        Screen.of(ExitCode.BAD_INPUT, List.of(new CheckSolverCommand()), OptionStyle.SHELL, "checkSolver",
                "--solver=" + Halts.class.getName(), "--out=" + folder.resolve("report"));
        assertFalse(Files.exists(folder.resolve("report/checkSolver.md")));
    }

    @Test
    void anUnknownNameSaysWhatIsKnown(@TempDir Path folder) {
        assertHas(here(ExitCode.BAD_INPUT, "HeunSolver", folder),
                "no class is called 'exercises.HeunSolver'; classes in the folder of exercises: []; "
                        + "known solvers: [euler,");
    }

    /** Java counts 247 MB of 256 MB as usable with its serial collector. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            Exits     | the class ends the whole program (System.exit), in Exits.stepState, line
            Overflows | the stack overflows: a method calls itself without end, in Overflows.
            Hoards    | it asks for more memory than the 247 MB that there are, in Hoards.stepState
            """)
    void aClassThatDoesNotComeBackIsFoundOut(String planted, String failure, @TempDir Path folder) throws Exception {
        Class<?> solver = Class.forName(CheckSolverCommandTest.class.getName() + "$" + planted);
        assertStarts(Checks.failureOf(check(solver.getName()), solver, folder), "failure: " + failure);
    }

    @Tag("slow")
    @Test
    void anEndlessLoopEndsTheCheckAndNotTheRun(@TempDir Path folder) throws Exception {
        aClassThatDoesNotComeBackIsFoundOut("Loops",
                "it did not come back within 7 s of CPU time: an endless loop, in Loops.stepState, line ", folder);
    }
}
