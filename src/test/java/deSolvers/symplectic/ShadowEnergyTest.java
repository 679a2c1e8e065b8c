package deSolvers.symplectic;

import static deSolvers.problems.Steps.assertRefused;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.DESolver;
import deSolvers.problems.Pendulum;
import org.junit.jupiter.api.Test;

/** How long "does not drift" is true where forces are not linear: a pendulum that swings to 2.9 rad, omega = 1. */
class ShadowEnergyTest {
    private static final int STEPS = 100_000;

    private static double energy(Pendulum pendulum) {
        double[] s = pendulum.getState();
        return s[1] * s[1] / 2 - StrictMath.cos(s[0]);
    }

    private static double worstError(DESolver solver, double h) {
        Pendulum pendulum = new Pendulum(2.9);
        double start = energy(pendulum);
        double worst = 0;
        for (int i = 0; i < STEPS; i++) {
            solver.stepState(pendulum, h);
            worst = Math.max(worst, Math.abs(energy(pendulum) - start));
        }
        return worst;
    }

    /** Measured 0.00331, 0.0301, 0.0851: of order h^2, and the same in a million steps. */
    @Test
    void inSmallStepsTheEnergySwingsAndDoesNotDrift() {
        assertEquals(0.00331, worstError(new VelocityVerletSolver(), 0.1), 1e-5);
        assertEquals(0.0301, worstError(new VelocityVerletSolver(), 0.3), 1e-4);
        assertEquals(0.0851, worstError(new VelocityVerletSolver(), 0.5), 1e-4);
    }

    /**
     * Far below the limit of 2 that a linear spring has. Measured with h = 0.8: 0.27, over the top; with 1.2 thousands.
     */
    @Test
    void inLongStepsItDoes() {
        double overTheTop = 1 + StrictMath.cos(2.9);
        assertTrue(worstError(new VelocityVerletSolver(), 0.8) > 5 * overTheTop);
        assertTrue(worstError(new VelocityVerletSolver(), 1.2) > 100);
    }

    /** The exact solution keeps the energy (measured 3e-15) up to the largest release; at 3.14159 it is lost. */
    @Test
    void aReleaseAtTheTopIsRefused() {
        double[] s = new Pendulum(3.14).exactState(1000);
        assertEquals(-StrictMath.cos(3.14), s[1] * s[1] / 2 - StrictMath.cos(s[0]), 1e-13);
        assertRefused(() -> new Pendulum(3.14159), () -> new Pendulum(Double.NaN));
    }
}
