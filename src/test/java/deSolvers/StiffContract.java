package deSolvers;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.problems.Decay;
import deSolvers.problems.ProtheroRobinson;
import deSolvers.problems.Steps;
import deSolvers.problems.StiffPair;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;

/**
 * Contract of solvers for stiff systems: no growth with steps far longer than the fastest decay. Assertions are static,
 * so that tests can show that explicit solvers fail them.
 */
public abstract class StiffContract {
    /** @return a new solver, which makes one step of its method for each call where it controls its steps */
    protected abstract DESolver createSolver();

    /** @return |R(-1e6)|, the factor of one step of s' = -1e6 s with deltaT = 1 */
    protected abstract double factorAtMinusAMillion();

    /** @return the order in deltaT on the stiff Prothero-Robinson problem, by theory */
    protected abstract double stiffOrder();

    /** @return a bound on the error of the Prothero-Robinson problem, L = -1e6, after 16 steps of 1/16 s */
    protected abstract double stiffError();

    /** @return a bound on the error of the 998/1998 pair after 100 steps of 0.01 s through its slow part */
    protected abstract double stiffPairError();

    @Test
    public void aMillionTimesTooLongAStepDoesNotGrow() {
        assertNoGrowth(createSolver(), factorAtMinusAMillion());
    }

    @Test
    public void theStiffOrderOfProtheroAndRobinsonHolds() {
        assertStiffOrder(this::createSolver, stiffOrder(), stiffError());
    }

    @Test
    public void theStiffPairIsFollowedWithStepsForItsSlowPart() {
        assertStiffPair(createSolver(), stiffPairError());
    }

    /**
     * Asserts that steps of s' = -1e6 s with deltaT = 1 never grow, and that the first multiplies by the given factor.
     *
     * @param solver what steps
     * @param factor |R(-1e6)|
     */
    public static void assertNoGrowth(DESolver solver, double factor) {
        Decay decay = new Decay(1e6);
        double before = 1;
        for (int i = 0; i < 20; i++) {
            solver.stepState(decay, 1);
            double after = Math.abs(decay.getState()[0]);
            assertTrue(after <= before, "step " + i + ": " + after + " after " + before);
            if (i == 0) {
                assertEquals(factor, after, 1e-9 * factor);
            }
            before = after;
        }
    }

    /**
     * Asserts that the error on the Prothero-Robinson problem, L = -1e6, is small and falls with the theoretical order.
     *
     * @param solvers what makes a new solver
     * @param order   the order in deltaT
     * @param bound   beyond the error after 16 steps of 1/16 s
     */
    public static void assertStiffOrder(Supplier<DESolver> solvers, double order, double bound) {
        double coarse = protheroRobinsonError(solvers.get(), 16);
        double fine = protheroRobinsonError(solvers.get(), 64);
        assertTrue(coarse < bound, "error " + coarse);
        double slope = StrictMath.log(coarse / fine) / StrictMath.log(4);
        assertEquals(order, slope, 0.1);
    }

    private static double protheroRobinsonError(DESolver solver, int steps) {
        ProtheroRobinson problem = new ProtheroRobinson(-1e6);
        double worst = 0;
        for (int i = 0; i < steps; i++) {
            solver.stepState(problem, 1.0 / steps);
            worst = Math.max(worst, problem.error());
        }
        return worst;
    }

    /**
     * Asserts that the slow part of the 998/1998 pair is followed with steps ten times the explicit limit.
     *
     * @param solver what steps
     * @param bound  beyond the error after 100 steps of 0.01 s
     */
    public static void assertStiffPair(DESolver solver, double bound) {
        StiffPair pair = new StiffPair();
        for (int i = 0; i < 64 * 20; i++) {
            solver.stepState(pair, 1e-3 / 64);              // through the fast part with short steps
        }
        Steps.make(100, solver, pair, 0.01);
        assertTrue(pair.error() < bound, "error " + pair.error());
    }
}
