package deSolvers.adaptive;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;

/** Tests the guess of the first sub-step, and the trial step that it uses. */
class FirstSubStepTest {
    private static final double CLOSE = 2e-15;          // round-off of sums and roots; measured 2.2e-16

    private static double firstTried(double state, double deltaT, DoubleUnaryOperator slope) {
        Scripted solver = new Scripted(true, (offset, h) -> 0.81);
        solver.stepState(new Ramp(state, slope), deltaT);
        return solver.tried.get(0);
    }

    /**
     * Hairer, N&oslash;rsett and Wanner's guess: with d0 = |s|, d1 = |s'|, d2 = |s''| in units of the tolerance, the
     * root of 0.01/max(d1, d2), but no more than d0/d1 and deltaT.
     */
    @Test
    void theFirstGuessFollowsTheFormula() {
        for (double sign : new double[] {1, -1}) {
            assertEquals(sign * Math.sqrt(0.01 / 4), firstTried(100, sign * 50, t -> -4), CLOSE, "by d1");
            assertEquals(sign * Math.sqrt(0.01 / 9), firstTried(0, sign * 50, t -> 9 * t), CLOSE, "by d2");
            assertEquals(sign * Math.sqrt(0.01 / 9), firstTried(0.5, sign * 50, t -> 5 - 9 * t), CLOSE,
                    "by d2, from the trial");
            assertEquals(sign * 2e-4, firstTried(2, sign * 50, t -> 1e4), CLOSE, "by d0/d1");
            assertEquals(sign * 0.0625, firstTried(0, sign * 0.0625, t -> 1e-3), CLOSE, "all of deltaT");
            assertEquals(sign * 7, firstTried(0, sign * 7, t -> 0), CLOSE, "nothing moves");
            assertEquals(sign * 7, firstTried(3, sign * 7, t -> 0), CLOSE, "nothing moves");
        }
    }

    /**
     * The length of the trial step for the second derivative: a hundredth of d0/d1, or 1/d1 if the state is about 0.
     */
    @Test
    void theTrialStepHasItsLength() {
        assertEquals(0.01 * 50 / 4, trial(50, 4, 10), CLOSE);
        assertEquals(10, trial(50, 0, 10), CLOSE, "at rest");
        assertEquals(0.125, trial(50, 4, 0.125), CLOSE, "0.125 is all there is");
        assertEquals(0.25, trial(1, 4, 10), CLOSE, "a state of about 0 is one within its tolerance");
        assertEquals(10, trial(0, 0.1, 10), CLOSE);
        assertEquals(10, trial(0, 0.05, 10), CLOSE);
        assertEquals(5, trial(0, 0.2, 10), CLOSE);
        assertEquals(-5, trial(0, 0.2, -10), CLOSE);
    }

    private static double trial(double state, double slope, double deltaT) {
        Ramp source = new Ramp(state, t -> slope);
        new Scripted(true, (offset, h) -> 0).stepState(source, deltaT);
        assertEquals(2, source.asked.size());
        return source.asked.get(1);
    }

    /** A derivative that overflows, or is too large for a trial step, still gives a first sub-step. */
    @Test
    void theGuessIsAlwaysAPositiveLength() {
        assertEquals(0.02, firstTried(8, 50, t -> t > 0.01 ? Double.POSITIVE_INFINITY : 4), CLOSE,
                "as long as the trial");
        assertEquals(1e-310, firstTried(1, 1e-310, t -> 1), 0);
        assertEquals(1e-300, firstTried(1, 1e-300, t -> 1), 0);
    }

    /** The second derivative is that along the solution: of s' = s^2, s'' = 2 s^3, by a trial from 0.5 to 1.5. */
    @Test
    void theTrialFollowsTheSolution() {
        Scripted solver = new Scripted(true, (offset, h) -> 0.81);
        Ramp square = new Ramp(0.5, t -> 0) {
            @Override
            protected void rates(double t, double[] s, double[] dSdt) {
                asked.add(t);
                dSdt[0] = s[0] * s[0];
            }
        };
        solver.stepState(square, 50);
        assertEquals(4, square.asked.get(1), CLOSE, "1/d1");
        assertEquals(Math.sqrt(0.01 / ((2.25 - 0.25) / 4)), solver.tried.get(0), CLOSE);
    }
}
