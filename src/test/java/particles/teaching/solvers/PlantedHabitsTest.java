package particles.teaching.solvers;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.teaching.solvers.PlantedSolvers.assertFound;
import static particles.teaching.solvers.PlantedSolvers.euler;
import static particles.teaching.solvers.PlantedSolvers.midpoint;
import static particles.teaching.solvers.PlantedSolvers.slope;
import static particles.teaching.solvers.PlantedSolvers.slopeAt;
import static particles.teaching.solvers.PlantedSolvers.solver;
import static particles.teaching.solvers.PlantedSolvers.state;
import static particles.teaching.solvers.PlantedSolvers.with;

import deSolvers.DESolver;
import deSolvers.DEStateSource;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Mistakes that a formula does not show: what is kept, shared, random, cut off or laid out otherwise. */
class PlantedHabitsTest {

    /** Takes deltaT from its first call. */
    private static final class FirstDeltaT extends DESolver {
        private double h;

        @Override
        public void stepState(DEStateSource source, double deltaT) {
            h = h == 0 ? deltaT : h;
            double[] dSdt = slope(source);
            source.setState(with(state(source), i -> h * dSdt[i]));
            source.incTime(deltaT);
        }
    }

    /** Takes deltaT from the call before. */
    private static final class PreviousDeltaT extends DESolver {
        private double previous;

        @Override
        public void stepState(DEStateSource source, double deltaT) {
            double h = previous == 0 ? deltaT : previous;
            double[] dSdt = slope(source);
            source.setState(with(state(source), i -> h * dSdt[i]));
            source.incTime(deltaT);
            previous = deltaT;
        }
    }

    /** Adams-Bashforth of order 2 as the contract wants it: whatever is not what it left makes it begin again. */
    private static final class CarefulAdamsBashforth extends DESolver {
        private DEStateSource source;
        private double[] state = {};
        private double[] last = {};
        private double time;
        private double deltaT;

        @Override
        public void stepState(DEStateSource source, double deltaT) {
            double[] now = slope(source);
            double[] start = state(source);
            boolean goesOn = source == this.source && source.getTime() == time && deltaT == this.deltaT
                    && Arrays.equals(start, state);
            double[] before = goesOn ? last : now;
            state = with(start, i -> deltaT * (1.5 * now[i] - 0.5 * before[i]));
            source.setState(state);
            source.incTime(deltaT);
            this.source = source;
            this.deltaT = deltaT;
            time = source.getTime();
            last = now;
        }

        @Override
        public void reset() {
            source = null;
        }
    }

    @Test
    void randomNumbers() {
        Random random = new Random(715);
        assertFound("Mine", () -> euler((dSdt, deltaT) -> dSdt * deltaT * (1 + 0.1 * random.nextDouble())),
                "method: two new solvers make different steps from the same place: something is random, or static");
    }

    @Test
    void aFieldThatAllSolversShare() {
        double[] shared = {0};
        assertFound("Mine", () -> solver((source, deltaT) -> {
            double[] dSdt = slope(source);
            shared[0] += deltaT;
            source.setState(with(state(source), i -> shared[0] * dSdt[i]));
            source.incTime(deltaT);
        }), "method: two new solvers make different steps from the same place: something is random, or static");
    }

    @Test
    void deltaTOfAnotherStep() {
        String kept = "state: deltaT changes from one step to the next, and the step is not the one that a new solver "
                + "makes with it: deltaT of an"
                + " earlier step is kept";
        assertFound("Mine", FirstDeltaT::new, kept);
        assertFound("Mine", PreviousDeltaT::new, kept);
    }

    @Test
    void theWholeStepTwice() {
        assertFound("Mine", () -> solver((source, deltaT) -> {
            for (int twice = 0; twice < 2; twice++) {
                double[] dSdt = slope(source);
                source.setState(with(state(source), i -> deltaT * dSdt[i]));
                source.incTime(deltaT);
            }
        }), "method: the parts of the step lead to t + 2 deltaT, and have to lead to t + deltaT: is the step");
    }

    @Test
    void oneHalfOfWholeNumbers() {
        assertFound("MidpointSolver", () -> midpoint(1 / 2, 0.5, 0.5),
                "method: gMid is evaluated at s; the slide says s + deltaS/2: no derivative is in it: it was not added "
                        + "to the state that is set, or 1/2 is 0 in Java");
    }

    @Test
    void theNewTimeHandedToIncTime() {
        assertFound("Mine", () -> solver((source, deltaT) -> {
            double[] dSdt = slope(source);
            source.setState(with(state(source), i -> deltaT * dSdt[i]));
            source.incTime(source.getTime() + deltaT);
        }), "time: the clock moves by 65/32 s in a step of 1/32 s that"
                + " begins at 2 s: incTime takes how far the clock moves");
    }

    @Test
    void theTimeInsteadOfDeltaT() {
        assertFound("Mine", () -> solver((source, deltaT) -> {
            double[] dSdt = slope(source);
            double t = source.getTime();
            source.setState(with(state(source), i -> t * dSdt[i]));
            source.incTime(deltaT);
        }), "method: the new state is s + 8 k1, which does not follow deltaT:"
                + " its length is the time, source.getTime(), and deltaT is ignored");
    }

    @Test
    void aDerivativeCutOff() {
        assertFound("Mine", () -> euler((dSdt, deltaT) -> deltaT * Math.max(-1, Math.min(1, dSdt))),
                "method: with derivatives up to 1000 the step is not the one that it makes with derivatives up to 1: "
                        + "something is cut off");
    }

    @Test
    void aDerivativeRounded() {
        assertFound("Mine", () -> euler((dSdt, deltaT) -> deltaT * Math.round(dSdt * 1000) / 1000.0),
                "state: digits get lost");
    }

    @Test
    void theStateSplitInHalves() {
        assertFound("Mine", () -> solver((source, deltaT) -> {
            double[] s = state(source);
            double[] dSdt = slope(source);
            int half = s.length / 2;
            for (int i = 0; i < half; i++) {
                s[i + half] += deltaT * dSdt[i + half];
                s[i] += deltaT * s[i + half];
            }
            source.setState(s);
            source.incTime(deltaT);
        }), "state: with one particle the error goes to 0 with deltaT, with two it does not");
    }

    @Test
    void onlyTheFirstEntries() {
        assertFound("Mine", () -> solver((source, deltaT) -> {
            double[] s = state(source);
            double[] dSdt = slope(source);
            for (int i = 0; i < 3; i++) {
                s[i] += deltaT * dSdt[i];
            }
            source.setState(s);
            source.incTime(deltaT);
        }), "state: these entries stay as they were in the new state: 3, 4, 5, 6, 7, 8...; the loop has to");
    }

    @Test
    void theClockMovedAtEveryStage() {
        assertFound("RK4Solver", () -> PlantedSolvers.rk4(PlantedSolvers.PLACES, new double[] {1, 1, 1, 1},
                PlantedSolvers.WEIGHTS),
                "time: the clock ends at t + 4 deltaT after a step of deltaT = 1/32 s and has to end at t + deltaT");
    }

    @Test
    void tenEulerStepsAreNoMistake() {
        DESolver tenth = solver((source, deltaT) -> {
            for (int k = 0; k < 10; k++) {
                double[] dSdt = slopeAt(source, state(source));
                source.setState(with(state(source), i -> deltaT / 10 * dSdt[i]));
                source.incTime(deltaT / 10);
            }
        });
        SolverVerdict verdict = SolverCheck.check(() -> tenth, "Mine");
        assertEquals(List.of(), verdict.wrong());
        assertEquals("This is the Euler method in 10 sub-steps.", verdict.identity());
    }

    @Test
    void whatIsRememberedOfEarlierStepsHasToBeForgotten() {
        assertEquals(List.of(), SolverCheck.check(CarefulAdamsBashforth::new, "Mine").wrong());
        assertTrue(SolverCheck.check(CarefulAdamsBashforth::new, "Mine").multistep());
        assertFound("Mine", PlantedSolvers.AdamsBashforth2::new,
                "state: the state was set from outside, as a collision does, and the step"
                + " afterwards still uses the steps before it. What is remembered of earlier steps may be used only "
                + "while source, time, state");
    }
}
