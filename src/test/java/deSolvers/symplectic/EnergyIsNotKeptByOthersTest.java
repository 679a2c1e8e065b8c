package deSolvers.symplectic;

import static org.junit.jupiter.api.Assertions.assertThrows;

import deSolvers.DESolver;
import deSolvers.EulerSolver;
import deSolvers.MidpointSolver;
import deSolvers.RK4Solver;
import deSolvers.implicit.BackwardEulerSolver;
import deSolvers.multistep.AdamsBashforthMoultonSolver;
import org.junit.jupiter.api.Test;
import org.opentest4j.AssertionFailedError;

/** The test of {@link EnergyKeeping} can fail: it does for every method that is not symplectic. */
class EnergyIsNotKeptByOthersTest {

    @Test
    void theSameTestFailsForTheOthers() {
        for (DESolver solver : new DESolver[] {new EulerSolver(), new MidpointSolver(), new RK4Solver(),
            new AdamsBashforthMoultonSolver()}) {
            // With verlet's bound h^2/4, and by drift alone with one that only a blow-up would exceed.
            assertThrows(AssertionFailedError.class, () -> EnergyKeeping.check(solver, 0.25, 0.25 * 0.25 / 4));
            assertThrows(AssertionFailedError.class, () -> EnergyKeeping.check(solver, 0.25, 10));
        }
    }

    /** Backward Euler loses the energy at once, by 1/(1 + h^2) a step. */
    @Test
    void theSameTestFailsForBackwardEuler() {
        assertThrows(AssertionFailedError.class,
                () -> EnergyKeeping.check(new BackwardEulerSolver(), 0.25, 0.25 * 0.25 / 4));
    }
}
