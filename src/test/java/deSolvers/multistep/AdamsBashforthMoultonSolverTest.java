package deSolvers.multistep;

import static deSolvers.problems.Bounds.assertAbove;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.DESolver;
import deSolvers.FixedStepContract;
import deSolvers.StepMatrixFormula;
import deSolvers.problems.ForcedOscillator;
import deSolvers.problems.Law;
import deSolvers.problems.ReferenceProblem;
import deSolvers.problems.Steps;
import org.junit.jupiter.api.Test;

/** The order, and restarts when earlier steps are no longer valid. */
class AdamsBashforthMoultonSolverTest extends FixedStepContract {
    private static final double H = 0.0625;

    /** The first step after a restart is RK4. */
    AdamsBashforthMoultonSolverTest() {
        super(AdamsBashforthMoultonSolver::new, 4,
                h -> StepMatrixFormula.polynomial(h, 1, 1, 1.0 / 2, 1.0 / 6, 1.0 / 24));
    }

    /** Its higher error terms are larger than those of a one-step method: 4.065 between 100 and 200 steps. */
    @Override
    protected int[] orderSteps() {
        return new int[] {300, 600};
    }

    private static long evaluationsOf(DESolver solver, ReferenceProblem problem, int steps) {
        long before = problem.getEvaluations();
        Steps.make(steps, solver, problem, H);
        return problem.getEvaluations() - before;
    }

    /** Three steps of RK4, then two evaluations per step. */
    private static long evaluationsOfACourse(int steps) {
        return 4L * Math.min(steps, 3) + 2L * Math.max(0, steps - 3);
    }

    @Test
    void stepsAfterTheStartTakeFewerEvaluations() {
        assertEquals(evaluationsOfACourse(20), evaluationsOf(createSolver(), new ForcedOscillator(), 20));
    }

    @Test
    void anyInterruptionRestarts() {
        ForcedOscillator problem = new ForcedOscillator();
        DESolver solver = createSolver();
        evaluationsOf(solver, problem, 10);
        assertEquals(20, evaluationsOf(solver, problem, 10), "no interruption");
        solver.reset();
        assertEquals(evaluationsOfACourse(10), evaluationsOf(solver, problem, 10), "reset()");
        double[] state = problem.getState();
        state[1] = -state[1];
        problem.setState(state);                        // a bounce
        assertEquals(evaluationsOfACourse(10), evaluationsOf(solver, problem, 10), "another state");
        problem.incTime(1);
        assertEquals(evaluationsOfACourse(10), evaluationsOf(solver, problem, 10), "another time");
        solver.stepState(problem, H / 2);
        assertEquals(evaluationsOfACourse(10), evaluationsOf(solver, problem, 10), "another deltaT before");
        solver.stepState(new ForcedOscillator(), H);
        assertEquals(evaluationsOfACourse(10), evaluationsOf(solver, problem, 10), "another source before");
    }

    /** After a kick every 16 steps, as by a bounce, the steps have the same bits as a new solver's. */
    @Test
    void aKickClearsTheHistory() {
        ForcedOscillator problem = new ForcedOscillator();
        DESolver solver = createSolver();
        for (int bounce = 0; bounce < 5; bounce++) {
            double[] state = problem.getState();
            state[1] += 0.5;
            problem.setState(state);
            ForcedOscillator twin = new ForcedOscillator();
            twin.setState(state);
            twin.incTime(problem.getTime());
            evaluationsOf(solver, problem, 16);
            evaluationsOf(createSolver(), twin, 16);
            assertArrayEquals(twin.getState(), problem.getState());
        }
    }

    /**
     * A law that changes while state, time and deltaT continue is not noticed: old derivatives spoil the next steps.
     */
    @Test
    void withoutResetAChangedLawSpoilsTheNextSteps() {
        double told = errorWithJump(true);
        double untold = errorWithJump(false);
        assertEquals(0, told);
        assertAbove(0.01, untold);  // a quarter of a step, H/4
    }

    /** s' = 1 until t = 1, then s' = -1, switched by hand. */
    private double errorWithJump(boolean reset) {
        double[] rate = {1};
        Law problem = new Law((t, s, dSdt) -> dSdt[0] = rate[0], t -> new double[] {t <= 1 ? t : 2 - t});
        DESolver solver = createSolver();
        evaluationsOf(solver, problem, 16);
        rate[0] = -1;
        if (reset) {
            solver.reset();
        }
        evaluationsOf(solver, problem, 16);
        return problem.error();
    }

    /** Both formulas integrate a polynomial of degree 4 exactly; one of degree 5 they do not. */
    @Test
    void polynomialsUpToDegreeFourAreExact() {
        for (int degree = 1; degree <= 5; degree++) {
            final int m = degree;
            Law problem = new Law((t, s, dSdt) -> dSdt[0] = m * StrictMath.pow(t, m - 1),
                    t -> new double[] {StrictMath.pow(t, m)});
            DESolver solver = createSolver();
            Steps.make(64, solver, problem, 1.0 / 64);
            // The three steps of RK4 are Simpson's rule here, exact as well. Measured 0 up to degree 4, 1.8e-7 at 5.
            assertTrue(degree <= 4 ? problem.error() < 1e-15 : problem.error() > 1e-8, degree + ": " + problem.error());
        }
    }
}
