package deSolvers;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.problems.ProtheroRobinson;
import deSolvers.problems.ReferenceProblem;
import deSolvers.problems.StiffPair;
import org.junit.jupiter.api.Test;

/** What a solver for stiff systems promises besides: steps that are far longer than what decays, without growth. */
public abstract class StiffContract {

    /** s' = -1e6 s. */
    private static final class FastDecay extends ReferenceProblem {
        FastDecay() {
            super(1);
            startAt(0);
        }

        @Override
        public double[] exactState(double t) {
            return new double[] {StrictMath.exp(-1e6 * t)};
        }

        @Override
        protected void rates(double t, double[] s, double[] dSdt) {
            dSdt[0] = -1e6 * s[0];
        }
    }

    /** @return a new solver, which makes one step of its method for each call where it controls its steps */
    protected abstract DESolver createSolver();

    /** @return |R(-1e6)|, what one step leaves of s' = -1e6 s with deltaT = 1 */
    protected abstract double factorAtMinusAMillion();

    /** @return the order in deltaT on the stiff Prothero-Robinson problem, by theory */
    protected abstract double stiffOrder();

    /** @return a bound on the error of the Prothero-Robinson problem, L = -1e6, after 16 steps of 1/16 s */
    protected abstract double stiffError();

    /** @return a bound on the error of the 998/1998 pair after 100 steps of 0.01 s through its slow part */
    protected abstract double stiffPairError();

    @Test
    public void aMillionTimesTooLongAStepDoesNotGrow() {
        FastDecay decay = new FastDecay();
        DESolver solver = createSolver();
        double before = 1;
        for (int i = 0; i < 20; i++) {
            solver.stepState(decay, 1);
            double after = Math.abs(decay.state()[0]);
            assertTrue(after <= before, "step " + i + ": " + after + " after " + before);
            if (i == 0) {
                assertEquals(factorAtMinusAMillion(), after, 1e-9 * factorAtMinusAMillion());
            }
            before = after;
        }
    }

    @Test
    public void theStiffOrderOfProtheroAndRobinsonHolds() {
        double coarse = protheroRobinsonError(16);
        double fine = protheroRobinsonError(64);
        assertTrue(coarse < stiffError(), "error " + coarse);
        double slope = StrictMath.log(coarse / fine) / StrictMath.log(4);
        assertEquals(stiffOrder(), slope, 0.1);
    }

    private double protheroRobinsonError(int steps) {
        ProtheroRobinson problem = new ProtheroRobinson(-1e6);
        DESolver solver = createSolver();
        double worst = 0;
        for (int i = 0; i < steps; i++) {
            solver.stepState(problem, 1.0 / steps);
            worst = Math.max(worst, problem.error());
        }
        return worst;
    }

    @Test
    public void theStiffPairIsFollowedWithStepsAsLongAsTheSlowPartAllows() {
        StiffPair pair = new StiffPair();
        DESolver solver = createSolver();
        solver.stepState(pair, 1e-3 / 64);                  // through the fast part with short steps
        for (int i = 1; i < 64 * 20; i++) {
            solver.stepState(pair, 1e-3 / 64);
        }
        for (int i = 0; i < 100; i++) {
            solver.stepState(pair, 0.01);                   // ten times what an explicit method could take
        }
        assertTrue(pair.error() < stiffPairError(), "error " + pair.error());
    }
}
