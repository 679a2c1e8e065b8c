package deSolvers.symplectic;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import deSolvers.DESolverException;
import deSolvers.SecondOrderStateSource;
import deSolvers.problems.LinearPair;
import deSolvers.problems.Oscillator;
import deSolvers.problems.PlainSource;
import deSolvers.problems.Steps;
import org.junit.jupiter.api.Test;

class VelocityVerletSolverTest extends SymplecticContract {
    VelocityVerletSolverTest() {
        super(VelocityVerletSolver::new, 2, VelocityVerletSolverTest::oscillatorStep);
    }

    /** Kick, drift, kick multiplied out. */
    static double[] oscillatorStep(double h) {
        double c = 1 - h * h / 2;
        return new double[] {c, h, -h * (1 - h * h / 4), c};
    }

    @Override
    double energyBound(double h) {
        return h * h / 4;
    }

    /** v' = -c v from v = 1. */
    private static LinearPair drag(double c) {
        LinearPair drag = LinearPair.spring(0, c);
        drag.start(1);
        return drag;
    }

    @Test
    void theClosingKickIsSolvedOrRefused() {
        LinearPair mild = drag(1);
        createSolver().stepState(mild, 0.5);
        assertEquals((1 - 0.25) / (1 + 0.25), mild.getState()[4], 1e-12);  // (1 - hc/2) / (1 + hc/2): implicit
        LinearPair stiff = drag(6);                                   // hc/2 = 1.5: the iteration diverges
        Steps.assertFails(DESolverException.class, "is too stiff", () -> createSolver().stepState(stiff, 0.5));
        assertArrayEquals(drag(6).getState(), stiff.getState());
    }

    @Test
    void aLayoutThatDoesNotFitIsRefused() {
        final class Wrong extends PlainSource implements SecondOrderStateSource {
            Wrong() {
                super(new Oscillator());
            }

            @Override
            public int getDimension() {
                return 3;                               // of a state of 2
            }
        }
        Steps.assertFails(IllegalArgumentException.class, "dimension 3",
                () -> createSolver().stepState(new Wrong(), 0.1));
    }
}
