package particles.teaching;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.teaching.PlantedSolvers.blocks;
import static particles.teaching.PlantedSolvers.euler;
import static particles.teaching.PlantedSolvers.midpoint;
import static particles.teaching.PlantedSolvers.rk4;
import static particles.teaching.PlantedSolvers.slope;
import static particles.teaching.PlantedSolvers.slopeAt;
import static particles.teaching.PlantedSolvers.solver;
import static particles.teaching.PlantedSolvers.state;
import static particles.teaching.PlantedSolvers.with;

import deSolvers.DESolver;
import java.util.List;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;

/** Every planted mistake is named, and nothing else is. */
class PlantedSolversTest {
    private static final double[] PLACES = {0.5, 0.5, 1};
    private static final double[] MOVES = {0.5, 0, 0.5, 0};
    private static final double[] WEIGHTS = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};
    private static final String NEW_STATE = "; the slide says s + k1/6 + k2/3 + k3/3 + k4/6";

    private static void assertFound(String name, Supplier<DESolver> maker, String... expected) {
        List<String> wrong = SolverCheck.check(maker, name).wrong().stream().map(Finding::toString).toList();
        assertEquals(expected.length, wrong.size(), wrong.toString());
        for (int k = 0; k < expected.length; k++) {
            assertTrue(wrong.get(k).startsWith(expected[k]), wrong.get(k) + " does not start with " + expected[k]);
        }
    }

    /** The scaffolding itself makes no mistakes. */
    @Test
    void withoutAMistakeNothingIsFound() {
        assertFound("Mine", () -> rk4(PLACES, MOVES, WEIGHTS));
        assertFound("Mine", () -> midpoint(0.5, 0.5, 0.5));
        assertFound("Mine", () -> euler((dSdt, deltaT) -> dSdt * deltaT));
        assertFound("Mine", () -> blocks(true));
        assertFound("Mine", () -> blocks(false));
        assertFound("SymplecticEuler", () -> blocks(true));
        assertFound("EulerSolver", () -> blocks(false));
    }

    @Test
    void wrongWeight() {
        assertFound("Mine", () -> rk4(PLACES, MOVES, new double[] {1.0 / 6, 1.0 / 3, 1.0 / 6, 1.0 / 6}),
                "method: the new state is s + k1/6 + k2/3 + k3/6 + k4/6" + NEW_STATE + ": the weight of k3 is 1/6 instead of 1/3");
    }

    @Test
    void k2FromK1WithoutTheHalf() {
        assertFound("Mine", () -> rk4(new double[] {1, 0.5, 1}, MOVES, WEIGHTS),
                "method: k2 is evaluated at s + k1; the slide says s + k1/2: the half is missing");
    }

    @Test
    void midpointWithoutTheHalf() {
        assertFound("Mine", () -> midpoint(1, 0.5, 0.5),
                "method: gMid is evaluated at s + deltaS; the slide says s + deltaS/2: the half is missing");
    }

    @Test
    void k4AtTheWrongTime() {
        assertFound("Mine", () -> rk4(PLACES, new double[] {0.5, 0, 0, 0.5}, WEIGHTS),
                "time: k4 is evaluated at t + deltaT/2; the slide says t + deltaT");
    }

    @Test
    void clockMovedOnlyAtTheEnd() {
        assertFound("Mine", () -> rk4(PLACES, new double[] {0, 0, 0, 1}, WEIGHTS),
                "time: k2, k3 and k4 are evaluated at t; the slide says t + deltaT/2, t + deltaT/2 and t + deltaT");
    }

    @Test
    void noIncTime() {
        assertFound("Mine", () -> solver((source, deltaT) -> {
            double[] dSdt = slope(source);
            source.setState(with(state(source), i -> deltaT * dSdt[i]));
        }), "time: the clock never moves: incTime(deltaT) is missing");
        assertFound("Mine", () -> solver((source, deltaT) -> {
            double[] state = state(source);
            double[] dSdt = slope(source);
            double[] gMid = slopeAt(source, with(state, i -> deltaT / 2 * dSdt[i]));
            source.setState(with(state, i -> deltaT * gMid[i]));
        }), "time: the clock never moves: incTime(deltaT) is missing");
    }

    @Test
    void incTimeTwice() {
        assertFound("Mine", () -> solver((source, deltaT) -> {
            double[] dSdt = slope(source);
            source.setState(with(state(source), i -> deltaT * dSdt[i]));
            source.incTime(deltaT);
            source.incTime(deltaT);
        }), "time: the clock moves by 2 deltaT: incTime(deltaT) is called 2 times, once is right");
    }

    @Test
    void theHalfStepOfTheClockStaysOn() {
        assertFound("Mine", () -> midpoint(0.5, 0.5, 1),
                "time: the clock ends at t + 3/2 deltaT and has to end at t + deltaT; it was moved by deltaT/2, then deltaT");
    }

    @Test
    void stateLeftAtAStage() {
        assertFound("Mine", () -> solver((source, deltaT) -> {
            double[] state = state(source);
            double[] dSdt = slope(source);
            source.incTime(deltaT / 2);
            slopeAt(source, with(state, i -> deltaT / 2 * dSdt[i]));
            source.incTime(deltaT / 2);
        }), "state: the state is left at a trial state, s + k1/2, that of the last evaluation: setState with the new state is missing");
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
        }), "method: gMid is evaluated at s; the slide says s + deltaS/2: setState is missing before this getStateDerivative");
    }

    @Test
    void derivativeOfAnEarlierStep() {
        assertFound("Mine", PlantedSolvers.StaleDerivative::new,
                "state: the derivative is stale: getStateDerivative is called in the first step only");
    }

    @Test
    void newVelocityWhereEulerTakesTheOld() {
        assertFound("EulerSolver", () -> blocks(true), "method: the position is updated with the new velocity; the slide's Euler method takes the old");
    }

    @Test
    void oldVelocityWhereTheSimpleAlgorithmTakesTheNew() {
        assertFound("SymplecticEulerSolver", () -> blocks(false),
                "method: the position is updated with the old velocity, which is the Euler method; the slides' simple algorithm takes the new");
    }

    @Test
    void deltaTIgnored() {
        assertFound("Mine", () -> euler((dSdt, deltaT) -> dSdt), "method: the new state does not follow deltaT: deltaT is ignored");
    }

    @Test
    void deltaTHardCoded() {
        assertFound("Mine", () -> euler((dSdt, deltaT) -> 0.01 * dSdt),
                "method: the new state does not follow deltaT: a time step of 0.01000 s is hard-coded, and deltaT is ignored");
    }

    @Test
    void clockHardCoded() {
        assertFound("Mine", () -> solver((source, deltaT) -> {
            double[] dSdt = slope(source);
            source.setState(with(state(source), i -> deltaT * dSdt[i]));
            source.incTime(0.125);
        }), "time: the clock moves by 1/8 s in every step, whatever deltaT is: it is hard-coded");
    }

    @Test
    void derivativeDividedByDeltaT() {
        assertFound("Mine", () -> euler((dSdt, deltaT) -> dSdt / deltaT),
                "method: the new state does not follow deltaT: the derivative is divided by deltaT; it has to be multiplied by deltaT");
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
                "state: the state was set from outside, as a collision does, and the step afterwards does not start there: an array is kept");
    }

    @Test
    void sizeCachedFromTheFirstSource() {
        assertFound("Mine", PlantedSolvers.CachedSize::new, "state: the solver stepped a source of 18 numbers and then one of 36, and");
    }

    @Test
    void signError() {
        assertFound("Mine", () -> euler((dSdt, deltaT) -> -dSdt * deltaT),
                "method: the new state is s - deltaS; the slide says s + deltaS: the sign is wrong");
    }

    @Test
    void lastStageForgotten() {
        assertFound("RK4Solver", () -> solver((source, deltaT) -> {
            double[] state = state(source);
            double[] k1 = slope(source);
            source.incTime(deltaT / 2);
            double[] k2 = slopeAt(source, with(state, i -> deltaT / 2 * k1[i]));
            double[] k3 = slopeAt(source, with(state, i -> deltaT / 2 * k2[i]));
            source.setState(with(state, i -> deltaT * (k1[i] / 6 + k2[i] / 3 + k3[i] / 3)));
            source.incTime(deltaT / 2);
        }), "method: k4 is missing: getStateDerivative is called 3 times, the slide needs 4 times");
    }

    @Test
    void wholeNumbersDivided() {
        assertFound("RK4Solver", () -> rk4(PLACES, MOVES, new double[] {1 / 6, 1 / 3, 1 / 3, 1 / 6}),
                "method: the new state is s" + NEW_STATE + ": no evaluation is in it; 1/6 is 0 in Java");
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
        }), "method: k3 is evaluated at s + k1/2 + k2/2; the slide says s + k2/2: go back to the start s before adding");
    }

    @Test
    void stepTakenFromTheMiddle() {
        assertFound("MidpointSolver", () -> solver((source, deltaT) -> {
            double[] state = state(source);
            double[] dSdt = slope(source);
            source.incTime(deltaT / 2);
            double[] gMid = slopeAt(source, with(state, i -> deltaT / 2 * dSdt[i]));
            source.setState(with(state(source), i -> deltaT * gMid[i]));
            source.incTime(deltaT / 2);
        }), "method: the new state is s + deltaS/2 + deltaT gMid; the slide says s + deltaT gMid: go back to the start s before taking the step");
    }

    @Test
    void oneArrayForAllSlopes() {
        assertFound("RK4Solver", () -> rk4(PLACES, MOVES, new double[] {0, 0, 0, 1}),
                "method: the new state is s + k4" + NEW_STATE + ": all of them are k4, as if k1 to k4 were one array");
    }

    @Test
    void heunWithoutTheHalf() {
        assertFound("HeunSolver", () -> solver((source, deltaT) -> {
            double[] state = state(source);
            double[] k1 = slope(source);
            source.incTime(deltaT);
            double[] k2 = slopeAt(source, with(state, i -> deltaT * k1[i]));
            source.setState(with(state, i -> deltaT * (k1[i] + k2[i])));
        }), "method: the new state is s + k1 + k2; Heun's method says s + k1/2 + k2/2: the half is missing");
    }

    @Test
    void anotherMethodThanTheNameSays() {
        assertFound("HeunSolver", () -> midpoint(0.5, 0.5, 0.5), "method: this is the midpoint method and not Heun's method, as its name says",
                "method: k2 is evaluated at s + k1/2; Heun's method says s + k1: it is halved", "time: k2 is evaluated at t + deltaT/2",
                "method: the new state is s + k2; Heun's method says s + k1/2 + k2/2: all of them are k2");
    }

    @Test
    void oldStateLost() {
        assertFound("Mine", () -> solver((source, deltaT) -> {
            double[] dSdt = slope(source);
            source.setState(with(new double[dSdt.length], i -> deltaT * dSdt[i]));
            source.incTime(deltaT);
        }), "state: the old state is lost: the new state is k1 and has to be s plus that");
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
        }), "state: entry 23 of a state of 24 numbers stays as it was: the loop over i");
    }

    @Test
    void notANumber() {
        assertFound("Mine", () -> euler((dSdt, deltaT) -> Math.sqrt(-1 - dSdt * dSdt)), "state: the new state is NaN");
    }

    @Test
    void verletWithTheOldAccelerationOnly() {
        assertFound("VerletSolver", () -> solver((source, deltaT) -> {
            double[] state = state(source);
            double[] dSdt = slope(source);
            for (int x = 0; x < state.length; x += x % 6 == 2 ? 4 : 1) {
                state[x] += state[x + 3] * deltaT + dSdt[x + 3] * deltaT * deltaT / 2;
                state[x + 3] += dSdt[x + 3] * deltaT;
            }
            source.setState(state);
            source.incTime(deltaT);
        }), "method: evaluations of the acceleration in a step: 1; velocity Verlet (leapfrog: kick, drift, kick) needs 2: the one at the new"
                + " position is missing", "method: the new velocity is v + a1 deltaT; the method says v + a1 deltaT/2 + a2 deltaT/2");
    }

    @Test
    void exception() {
        assertFound("Mine", () -> solver((source, deltaT) -> state(source)[source.getStateSize()]++),
                "failure: stepState ends in an exception: java.lang.ArrayIndexOutOfBoundsException: Index 12 out of bounds for length 12, in ");
    }
}
