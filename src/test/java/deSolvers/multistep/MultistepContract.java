package deSolvers.multistep;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.DESolver;
import deSolvers.FixedStepContract;
import deSolvers.problems.ForcedOscillator;
import deSolvers.problems.ReferenceProblem;
import deSolvers.problems.Steps;
import org.junit.jupiter.api.Test;

/** Contract of multistep solvers: they restart when earlier steps are no longer valid. */
public abstract class MultistepContract extends FixedStepContract {
    private static final double H = 0.0625;

    /** @return the number of starting steps by another method */
    protected abstract int startingSteps();

    /** @return evaluations in a starting step */
    protected abstract int evaluationsAStartingStep();

    /** @return evaluations in a step after that */
    protected abstract int evaluationsAStep();

    private long evaluationsOf(DESolver solver, ReferenceProblem problem, int steps) {
        long before = problem.getEvaluations();
        Steps.make(steps, solver, problem, H);
        return problem.getEvaluations() - before;
    }

    private long evaluationsOfACourse(int steps) {
        int starting = Math.min(steps, startingSteps());
        return (long) starting * evaluationsAStartingStep() + (long) (steps - starting) * evaluationsAStep();
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
        assertEquals(10L * evaluationsAStep(), evaluationsOf(solver, problem, 10), "no interruption");
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
        assertTrue(untold > 0.01, "untold " + untold);  // a quarter of a step, H/4, for adams
    }

    /** s' = 1 until t = 1, then s' = -1, switched by hand. */
    private double errorWithJump(boolean reset) {
        double[] rate = {1};
        ReferenceProblem problem = new ReferenceProblem(0) {
            @Override
            public double[] exactState(double t) {
                return new double[] {t <= 1 ? t : 2 - t};
            }

            @Override
            protected void rates(double t, double[] s, double[] dSdt) {
                dSdt[0] = rate[0];
            }
        };
        DESolver solver = createSolver();
        evaluationsOf(solver, problem, 16);
        rate[0] = -1;
        if (reset) {
            solver.reset();
        }
        evaluationsOf(solver, problem, 16);
        return problem.error();
    }
}
