package deSolvers.adaptive;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import deSolvers.DESolver;
import deSolvers.DESolverContract;
import deSolvers.DESolverException;
import deSolvers.DenseOutput;
import deSolvers.problems.DragInWind;
import deSolvers.problems.GrowthInSeason;
import deSolvers.problems.Oscillator;
import deSolvers.problems.ReferenceProblem;
import java.lang.management.ManagementFactory;
import org.junit.jupiter.api.Test;

/** What a solver promises that gives the states in between. */
public abstract class DenseOutputContract extends DESolverContract {

    /** @return a new solver with these tolerances */
    protected abstract DESolver createSolver(double relativeTolerance, double absoluteTolerance);

    /** @return a bound on the error of the states in between, from the error at the end and the tolerance */
    protected double inBetween(double errorAtEnd, double tolerance) {
        return 5 * errorAtEnd;
    }

    @Test
    void theStatesInBetweenAreAsGoodAsTheStep() {
        for (double direction : new double[] {1, -1}) {
            DragInWind problem = new DragInWind(2, 2);
            DESolver solver = createSolver(1e-8, 1e-8);
            DenseOutput dense = (DenseOutput) solver;
            dense.setDenseOutput(true);
            problem.startAt(6);
            solver.stepState(problem, direction * 6);
            double worst = 0;
            double[] state = new double[problem.getStateSize()];
            for (int i = 0; i <= 1000; i++) {
                double t = 6 + direction * 6 * i / 1000;
                dense.getStateAt(t, state);
                double[] exact = problem.exactState(t);
                for (int j = 0; j < state.length; j++) {
                    worst = Math.max(worst, Math.abs(state[j] - exact[j]));
                }
            }
            // Measured up to 2.9 (step-doubling), 4.0 (dormand-prince), 2.1 (bulirsch-stoer) times the error at the end.
            assertTrue(worst < inBetween(problem.error(), 1e-8), worst + " in between, " + problem.error() + " at the end");
            dense.getStateAt(problem.getTime(), state);
            assertArrayEquals(problem.state(), state, 1e-13);
        }
    }

    @Test
    void theTrajectoryIsTheSameWithAndWithoutTheStatesInBetween() {
        DragInWind with = new DragInWind(2, 2);
        DragInWind without = new DragInWind(2, 2);
        DESolver dense = createSolver(1e-6, 1e-6);
        ((DenseOutput) dense).setDenseOutput(true);
        DESolver plain = createSolver(1e-6, 1e-6);
        for (int i = 0; i < 20; i++) {
            dense.stepState(with, 0.7);
            plain.stepState(without, 0.7);
            assertArrayEquals(without.state(), with.state());
        }
        assertTrue(with.evaluations() <= without.evaluations() + 1, with.evaluations() + " " + without.evaluations());
    }

    @Test
    void onlyTheLastStepCanBeAskedFor() {
        DESolver solver = createSolver(1e-6, 1e-6);
        DenseOutput dense = (DenseOutput) solver;
        double[] state = new double[1];
        GrowthInSeason problem = new GrowthInSeason();
        solver.stepState(problem, 1);
        assertThrows(IllegalStateException.class, () -> dense.getStateAt(0.5, state));
        dense.setDenseOutput(true);
        solver.stepState(problem, 1);
        dense.getStateAt(1.5, state);
        assertEquals(problem.exactState(1.5)[0], state[0], 1e-4);
        for (double outside : new double[] {0.999, 2.001, Double.NaN}) {
            assertThrows(IllegalArgumentException.class, () -> dense.getStateAt(outside, state));
        }
        assertThrows(IllegalArgumentException.class, () -> dense.getStateAt(1.5, new double[2]));
        solver.reset();
        assertThrows(IllegalStateException.class, () -> dense.getStateAt(1.5, state));
    }

    /** A step that fails, or cannot even begin, leaves nothing; one of no length changes nothing, here either. */
    @Test
    void aStepThatFailsLeavesNoStatesInBetween() {
        DESolver solver = createSolver(1e-6, 1e-6);
        DenseOutput dense = (DenseOutput) solver;
        dense.setDenseOutput(true);
        double[] state = new double[1];
        GrowthInSeason problem = new GrowthInSeason();
        for (double bad : new double[] {Double.NaN, Double.POSITIVE_INFINITY}) {
            solver.stepState(problem, 0.5);
            double middle = problem.getTime() - 0.25;
            dense.getStateAt(middle, state);
            double[] again = new double[1];
            solver.stepState(problem, 0);
            dense.getStateAt(middle, again);
            assertArrayEquals(state, again);
            assertThrows(DESolverException.class, () -> solver.stepState(problem, bad));
            assertThrows(IllegalStateException.class, () -> dense.getStateAt(middle, state));
            solver.stepState(problem, 0);
            assertThrows(IllegalStateException.class, () -> dense.getStateAt(middle, state));
        }
    }

    /** One radian of an oscillation, however short or long in time. */
    @Test
    void theStatesInBetweenAreNumbersAtEveryScaleOfTime() {
        for (double h : new double[] {1e-300, 1e-120, 1e-60, 1, 1e60, 1e100}) {
            ReferenceProblem problem = new ReferenceProblem(2) {
                @Override
                public double[] exactState(double t) {
                    return new double[] {StrictMath.cos(t / h), StrictMath.sin(t / h)};
                }

                @Override
                protected void rates(double t, double[] s, double[] dSdt) {
                    dSdt[0] = -s[1] / h;
                    dSdt[1] = s[0] / h;
                }
            };
            problem.startAt(0);
            DESolver solver = createSolver(1e-9, 1e-9);
            ((DenseOutput) solver).setDenseOutput(true);
            solver.stepState(problem, h);
            double[] state = new double[2];
            for (int i = 0; i <= 16; i++) {
                ((DenseOutput) solver).getStateAt(h * i / 16, state);
                // Measured up to 1.0e-8 (step-doubling), 7.6e-10 and less of the others; no NaN.
                assertEquals(StrictMath.cos(i / 16.0), state[0], 2e-8, h + ", " + i);
                assertEquals(StrictMath.sin(i / 16.0), state[1], 2e-8, h + ", " + i);
            }
        }
    }

    @Test
    void statesInBetweenCostNoMemoryInTheLongRun() {
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        Oscillator problem = new Oscillator();
        DESolver solver = createSolver();
        ((DenseOutput) solver).setDenseOutput(true);
        double[] state = new double[problem.getStateSize()];
        long before = 0;
        for (int i = 0; i < 1100; i++) {
            if (i == 100) {
                before = threads.getCurrentThreadAllocatedBytes();
            }
            solver.reset();
            solver.stepState(problem, 1);
            ((DenseOutput) solver).getStateAt(i + 0.5, state);
        }
        long bytes = threads.getCurrentThreadAllocatedBytes() - before;
        // Measured 72 at most, and up to 2584 (radau) while the compiler is still at work; one array a step would be 32,000.
        assertTrue(bytes < 8000, bytes + " bytes in 1000 steps");
    }
}
