package particles.teaching.solvers;

import static particles.teaching.solvers.PlantedSolvers.MOVES;
import static particles.teaching.solvers.PlantedSolvers.NEW_STATE;
import static particles.teaching.solvers.PlantedSolvers.PLACES;
import static particles.teaching.solvers.PlantedSolvers.assertFound;
import static particles.teaching.solvers.PlantedSolvers.euler;
import static particles.teaching.solvers.PlantedSolvers.rk4;
import static particles.teaching.solvers.PlantedSolvers.slope;
import static particles.teaching.solvers.PlantedSolvers.slopeAt;
import static particles.teaching.solvers.PlantedSolvers.solver;
import static particles.teaching.solvers.PlantedSolvers.state;
import static particles.teaching.solvers.PlantedSolvers.with;

import org.junit.jupiter.api.Test;

/** Mistakes with the state and with arrays. Every planted one is named, and nothing else is. */
class PlantedStateTest {
    @Test
    void stateLeftAtAStage() {
        assertFound("Mine", () -> solver((source, deltaT) -> {
            double[] state = state(source);
            double[] dSdt = slope(source);
            source.incTime(deltaT / 2);
            slopeAt(source, with(state, i -> deltaT / 2 * dSdt[i]));
            source.incTime(deltaT / 2);
        }), "state: the state is left at a trial state, s + k1/2, that of the last evaluation: setState with the new "
                + "state is missing");
    }

    @Test
    void newStateNeverSet() {
        assertFound("Mine", () -> solver((source, deltaT) -> {
            slope(source);
            source.incTime(deltaT);
        }), "state: the new state never reaches the source: setState(state) is missing");
    }

    @Test
    void setStateForgottenBeforeTheSecondEvaluation() {
        assertFound("MidpointSolver", () -> solver((source, deltaT) -> {
            double[] state = state(source);
            slope(source);
            source.incTime(deltaT / 2);
            double[] gMid = slope(source);
            source.setState(with(state, i -> deltaT * gMid[i]));
            source.incTime(deltaT / 2);
        }), "method: gMid is evaluated at s; the slide says s + deltaS/2: setState is missing before this "
                + "getStateDerivative");
    }

    @Test
    void derivativeOfAnEarlierStep() {
        assertFound("Mine", PlantedSolvers.StaleDerivative::new,
                "state: the derivative is stale: getStateDerivative is called in the first step only");
    }

    @Test
    void floatArithmetic() {
        assertFound("Mine", () -> solver((source, deltaT) -> {
            double[] state = state(source);
            double[] dSdt = slope(source);
            source.setState(with(new double[state.length], i -> (float) state[i] + (float) deltaT * (float) dSdt[i]));
            source.incTime(deltaT);
        }), "state: digits get lost");
    }

    @Test
    void keptArray() {
        assertFound("Mine", PlantedSolvers.KeptArray::new,
                "state: the state was set from outside, as a collision does, and the step afterwards does not start "
                        + "there: an array is kept");
    }

    @Test
    void sizeCachedFromTheFirstSource() {
        assertFound("Mine", PlantedSolvers.CachedSize::new,
                "state: the solver stepped a source of 18 numbers and then one of 36, and");
    }

    @Test
    void notBackToTheStart() {
        assertFound("RK4Solver", () -> solver((source, deltaT) -> {
            double[] state = state(source);
            double[] k1 = slope(source);
            source.incTime(deltaT / 2);
            double[] trial = with(state, i -> deltaT / 2 * k1[i]);
            double[] k2 = slopeAt(source, trial);
            double[] k3 = slopeAt(source, with(trial, i -> deltaT / 2 * k2[i]));
            source.incTime(deltaT / 2);
            double[] k4 = slopeAt(source, with(state, i -> deltaT * k3[i]));
            source.setState(with(state, i -> deltaT * (k1[i] / 6 + k2[i] / 3 + k3[i] / 3 + k4[i] / 6)));
        }), "method: k3 is evaluated at s + k1/2 + k2/2; the slide"
                + " says s + k2/2: go back to the start s before adding");
    }

    @Test
    void oneArrayForAllSlopes() {
        assertFound("RK4Solver", () -> rk4(PLACES, MOVES, new double[] {0, 0, 0, 1}),
                "method: the new state is s + k4" + NEW_STATE + ": only the last derivative is in it, as if all of "
                        + "them were one array");
    }

    @Test
    void oldStateLost() {
        assertFound("Mine", () -> solver((source, deltaT) -> {
            double[] dSdt = slope(source);
            source.setState(with(new double[dSdt.length], i -> deltaT * dSdt[i]));
            source.incTime(deltaT);
        }), "state: the new state is k1, with 0 times s in it instead of once: the old state is lost");
    }

    @Test
    void loopEndsTooEarly() {
        assertFound("Mine", () -> solver((source, deltaT) -> {
            double[] state = state(source);
            double[] dSdt = slope(source);
            for (int i = 0; i < state.length - 1; i++) {
                state[i] += deltaT * dSdt[i];
            }
            source.setState(state);
            source.incTime(deltaT);
        }), "state: these entries stay as they were in the new state: 23; the loop has to");
    }

    @Test
    void notANumber() {
        assertFound("Mine", () -> euler((dSdt, deltaT) -> Math.sqrt(-1 - dSdt * dSdt)), "state: the new state is NaN");
    }

    @Test
    void exception() {
        assertFound("Mine", () -> solver((source, deltaT) -> state(source)[source.getStateSize()]++),
                "failure: stepState ends in an exception: java.lang.ArrayIndexOutOfBoundsException: Index 12 out of "
                        + "bounds for length 12, in ");
    }
}
