package deSolvers.hard;

import static org.junit.jupiter.api.Assertions.assertEquals;

import deSolvers.problems.SecondOrderProblem;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * x'' = -x + cos t from rest: x = t/2 sin t. Hard, because the amplitude grows for ever by right, so that growth is no
 * sign of instability, and because an error of the method's frequency or damping, however small, puts it off resonance.
 */
@Tag("hard")
class ResonanceTest {
    private static final double H = 1.0 / 16;
    private static final int STEPS = 3200;

    private static final class Resonance extends SecondOrderProblem {
        Resonance() {
            super(1, 0, 0);
        }

        @Override
        public double[] exactState(double t) {
            double s = StrictMath.sin(t);
            return new double[] {t / 2 * s, s / 2 + t / 2 * StrictMath.cos(t)};
        }

        @Override
        protected void accelerate(double t, double[] s, double[] dSdt) {
            dSdt[1] = -s[0] + StrictMath.cos(t);
        }

        @Override
        public boolean accelerationDependsOnVelocity() {
            return false;
        }
    }

    private static HardRun run(String solver) {
        return HardRun.of(solver, new Resonance(), H, STEPS);
    }

    /**
     * After 200 s the amplitude is 100; the errors were measured, and are those of order 2, 4, 5 and the tolerance
     * 1e-6.
     */
    @ParameterizedTest
    @CsvSource({"midpoint, 5.8", "symplectic-euler, 1.3", "verlet, 1.5", "implicit-midpoint, 2.9", "rk4, 1.2e-3",
            "adams, 4.2e-3",
        "yoshida4, 9e-3", "step-doubling, 7.2e-5", "dormand-prince, 2.5e-6", "bulirsch-stoer, 7.2e-9", "radau, 1.2e-6"})
    void theAmplitudeGrowsLinearly(String solver, double measured) {
        assertEquals(100, run(solver).assertFollows(1.5 * measured).largest(), 0.5);
    }

    /** Its numerical damping of h/2 stops the growth near (1/2)/(h/2) = 16, where energy input and loss are equal. */
    @Test
    void backwardEulerDampsTheResonanceAway() {
        assertEquals(16, run("backward-euler").largest(), 0.1);
    }

    /** Euler adds a numerical growth of h/2 a second. */
    @Test
    void eulerAddsItsOwnGrowth() {
        assertEquals(16 * (StrictMath.exp(6.25) - 1), run("euler").largest(), 200,
                "1/(2 h/2) (e^(h t/2) - 1); measured 8129");
    }
}
