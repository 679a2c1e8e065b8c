package deSolvers.symplectic;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.DESolver;
import deSolvers.DESolverException;
import org.junit.jupiter.api.Test;

/** What steps of leapfrogs remember, and where they look for what is not finite. */
class LeapfrogTest {
    private static final double H = 0.5;

    /** Any number of particles on a line, all with the acceleration -1. */
    private static final class Falling extends Blocks {
        private double lastGoodTime = Double.POSITIVE_INFINITY;

        Falling() {
            super(1, 0, 0);
        }

        @Override
        public void getStateDerivative(double[] dSdt) {
            for (int x = 0; x < state.length; x += 2) {
                dSdt[x] = time <= lastGoodTime ? state[x + 1] : Double.NaN;
                dSdt[x + 1] = -1;
            }
        }
    }

    /** The first of the three ends at 1.35 H, beyond the step; no other one sees the time after H, and none uses that entry. */
    @Test
    void aDerivativeThatIsNotFiniteWithinTheStepIsNamed() {
        Falling source = new Falling();
        source.lastGoodTime = H;
        DESolverException e = assertThrows(DESolverException.class, () -> new Yoshida4Solver().stepState(source, H));
        assertTrue(e.getMessage().contains("entry 0 of the derivative is NaN at t = 0.67"), e.getMessage());
        assertEquals(0, source.time);
        assertArrayEquals(new double[2], source.state);
    }

    /** Its zeros are those of arrays that were just made, and source, time and deltaT are as the last step left them. */
    @Test
    void aSourceThatGrewAndIsAtRestBeginsAnew() {
        for (DESolver solver : new DESolver[] {new VelocityVerletSolver(), new Yoshida4Solver()}) {
            Falling source = new Falling();
            solver.stepState(source, H);
            source.state = new double[4];
            solver.stepState(source, H);
            assertArrayEquals(new double[] {-H * H / 2, -H, -H * H / 2, -H}, source.state, 1e-15);     // measured 0
        }
    }
}
