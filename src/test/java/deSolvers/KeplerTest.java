package deSolvers;

import static org.junit.jupiter.api.Assertions.assertEquals;

import deSolvers.problems.Kepler;
import deSolvers.problems.Orbit;
import deSolvers.symplectic.VelocityVerletSolver;
import org.junit.jupiter.api.Test;

/** The eccentric orbit e = 0.9 over T = 20 with h = 0.006; Hipparchus pins the first three numbers in its own tests. */
class KeplerTest {
    private static final double H = 0.006;

    private double largestEnergyError;

    private double largestSquaredError(DESolver solver) {
        Kepler orbit = new Kepler(0.9);
        double largest = 0;
        largestEnergyError = 0;
        double remaining = 20;
        while (remaining > 1e-9) {
            solver.stepState(orbit, Math.min(H, remaining));
            remaining = 20 - orbit.getTime();
            largest = Math.max(largest, Orbit.squaredError(orbit));
            largestEnergyError = Math.max(largestEnergyError, Math.abs((Orbit.energy(orbit) + 0.5) / 0.5));
        }
        return largest;
    }

    /** Bounds are one unit of the last digit given. */
    @Test
    void largestPositionErrorsMatchTheReference() {
        assertEquals(881.1761, largestSquaredError(new EulerSolver()), 1e-4);
        assertEquals(1.189274, largestSquaredError(new MidpointSolver()), 1e-6);
        assertEquals(5.823995e-3, largestSquaredError(new RK4Solver()), 1e-9);
        assertEquals(4.4088, largestSquaredError(new VelocityVerletSolver()), 1e-4);
        assertEquals(0.0910, largestEnergyError, 1e-4);
    }
}
