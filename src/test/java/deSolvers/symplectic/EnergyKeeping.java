package deSolvers.symplectic;

import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import deSolvers.DESolver;
import deSolvers.problems.Oscillator;

/** The test that a symplectic method passes and another does not. */
public final class EnergyKeeping {
    private static final int PERIODS = 100_000;
    private static final double FLOOR = 1e-10;

    private EnergyKeeping() {
    }

    /**
     * Runs x'' = -x from (1, 0) for 100,000 periods. The energy error must stay within the bound, and its largest value
     * in the last tenth must not exceed 1.1 times the one in the first.
     *
     * @param solver the solver to be tested
     * @param h      the step
     * @param bound  the largest energy error allowed, relative to the energy
     * @return the largest energy error in the first tenth
     */
    public static double check(DESolver solver, double h, double bound) {
        Oscillator oscillator = new Oscillator();
        double[] s = new double[2];
        int steps = (int) Math.ceil(PERIODS * 2 * Math.PI / h);
        double first = 0;
        double last = 0;
        for (int i = 0; i < steps; i++) {
            solver.stepState(oscillator, h);
            oscillator.getState(s);
            double error = Math.abs(s[0] * s[0] + s[1] * s[1] - 1);
            if (i < steps / 10) {
                first = Math.max(first, error);
            } else if (i >= steps - steps / 10) {
                last = Math.max(last, error);
            }
            // Rounding alone walks away from the bound by some sqrt(steps) units in the last place.
            if (!(error <= bound * (1 + 1e-9) + FLOOR)) {
                fail("step " + i + ": energy error " + error + ", bound " + bound);
            }
        }
        assertTrue(last <= 1.1 * Math.max(first, FLOOR), "energy error first " + first + ", last " + last);
        return first;
    }
}
