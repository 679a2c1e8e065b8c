package deSolvers.symplectic;

import static org.junit.jupiter.api.Assertions.assertEquals;

import deSolvers.DESolverException;
import deSolvers.SecondOrderStateSource;
import deSolvers.problems.PlainSource;
import deSolvers.problems.SecondOrderProblem;
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

    /** v' = -c v from v = 1, at 0. */
    private static final class Drag extends SecondOrderProblem {
        private final double c;

        Drag(double c) {
            super(1, 0, 1);
            this.c = c;
        }

        @Override
        public double[] exactState(double t) {
            double v = StrictMath.exp(-c * t);
            return new double[] {(1 - v) / c, v};
        }

        @Override
        protected void accelerate(double t, double[] s, double[] dSdt) {
            dSdt[1] = -c * s[1];
        }
    }

    @Test
    void theClosingKickIsSolvedOrRefused() {
        SecondOrderProblem mild = new Drag(1);
        createSolver().stepState(mild, 0.5);
        assertEquals((1 - 0.25) / (1 + 0.25), mild.getState()[1], 1e-12);  // (1 - hc/2) / (1 + hc/2): implicit
        SecondOrderProblem stiff = new Drag(6);                         // hc/2 = 1.5: the iteration diverges
        Steps.assertFails(DESolverException.class, "damping is too stiff", () -> createSolver().stepState(stiff, 0.5));
        assertEquals(0, stiff.error());
    }

    @Test
    void aLayoutThatDoesNotFitIsRefused() {
        final class Wrong extends PlainSource implements SecondOrderStateSource {
            Wrong() {
                super(new Drag(1));
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
