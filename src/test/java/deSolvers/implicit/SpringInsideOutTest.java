package deSolvers.implicit;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import deSolvers.DESolver;
import deSolvers.ForceDerivatives;
import deSolvers.JacobianStateSource;
import deSolvers.problems.SecondOrderProblem;
import org.junit.jupiter.api.Test;

/**
 * A particle on a stiff spring from the origin, which flies inwards so fast that without the spring it would come out
 * beyond. The step's equation has two solutions then: on this side, and on the other with the spring turned inside out.
 */
class SpringInsideOutTest {
    private static final double LENGTH = 1;
    private static final double STIFFNESS = 1e4;
    private static final double SPEED = -30;
    private static final double G = 0.05;
    private static final double CLOSE = 1e-14;         // a rounding of 40 m/s is 7e-15; measured 0

    /** x'' = -k (|x| - l) x/|x|, of mass 1. */
    private static final class Spring extends SecondOrderProblem implements JacobianStateSource {
        Spring() {
            super(3, LENGTH, 0, 0, SPEED, 0, 0);
        }

        private static double length(double[] s) {
            return Math.sqrt(s[0] * s[0] + s[1] * s[1] + s[2] * s[2]);
        }

        @Override
        protected void accelerate(double t, double[] s, double[] dSdt) {
            for (int c = 0; c < 3; c++) {
                dSdt[3 + c] = -STIFFNESS * (1 - LENGTH / length(s)) * s[c];
            }
        }

        private double derivative(double[] s, int e) {
            double r = length(s);
            double across = e % 4 == 0 ? 1 - LENGTH / r : 0;
            return -STIFFNESS * (across + LENGTH / r * s[e / 3] / r * s[e % 3] / r);
        }

        @Override
        public boolean hasExactJacobian() {
            return true;
        }

        @Override
        public void addJacobianBlocks(ForceDerivatives blocks) {
            double[] dFdX = new double[9];
            for (int e = 0; e < 9; e++) {
                dFdX[e] = derivative(getState(), e);
            }
            blocks.add(0, 0, dFdX, new double[9]);
        }
    }

    /**
     * Where x = side (l + ...): v = (v0 + g k l (side - 1))/(1 + g^2 k) solves v = v0 - g k (x - side l), x = l + g v.
     */
    private static double velocity(int side) {
        return (SPEED + G * STIFFNESS * LENGTH * (side - 1)) / (1 + G * G * STIFFNESS);
    }

    @Test
    void bothAreSolutions() {
        assertEquals(1, Math.signum(LENGTH + G * velocity(1)));
        assertEquals(-1, Math.signum(LENGTH + G * velocity(-1)));
        assertEquals(-1, Math.signum(LENGTH + G * SPEED), "and straight on leads beyond");
    }

    /** The midpoint rule looks for its middle from where the particle is, and keeps the spring as it was. */
    @Test
    void theMidpointRuleStaysOnThisSide() {
        Spring spring = new Spring();
        new ImplicitMidpointSolver().stepState(spring, 2 * G);
        double v = velocity(1);
        assertArrayEquals(new double[] {LENGTH + 2 * G * v, 0, 0, 2 * v - SPEED, 0, 0}, spring.getState(), CLOSE);
    }

    /**
     * So do backward Euler and its linearised step: along a line the force is linear, and both begin at the same place.
     */
    @Test
    void backwardEulerStaysOnThisSide() {
        double v = velocity(1);
        for (DESolver solver : new DESolver[] {new BackwardEulerSolver(), new LinearisedEulerSolver()}) {
            Spring spring = new Spring();
            solver.stepState(spring, G);
            assertArrayEquals(new double[] {LENGTH + G * v, 0, 0, v, 0, 0}, spring.getState(), CLOSE);
        }
    }
}
