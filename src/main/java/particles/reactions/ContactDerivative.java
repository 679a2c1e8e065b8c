package particles.reactions;

import deSolvers.ForceDerivatives;
import java.util.Arrays;
import particles.law.Particles;
import particles.law.Vector3;

/**
 * The derivative of the total force on a particle in contact, by central differences: with respect to the force before
 * contact, to the particle's own position and velocity, and to the position of its neighbour in a body with scales.
 * Products by differences of the whole system do not replace it: a cloth of 21 x 17 particles that falls on a rough
 * sphere, with linearised-euler and deltaT = 0.02 s, then ends at 0.26 s, where GMRES fails.
 */
final class ContactDerivative {
    private static final int STRIDE = Particles.STRIDE;
    /**
     * Relative to the force, speed or radius of curvature; the error is about 1e-9 of the largest entry, round-off.
     * Forces have kinks, where a contact ends or friction stops a particle. A difference across one belongs to neither
     * side: with 3e-5 Newton's method went round in circles on a draped cloth, at corrections of 9e-6.
     */
    private static final double STEP = 1e-7;

    private static final double[] NONE = new double[9];
    private final double[] byForce = new double[9];
    private final double[] byPosition = new double[9];
    private final double[] byVelocity = new double[9];
    private final double[] before = new double[3];

    /** Turns the forces of all effects (N) into the total force on one particle. */
    interface Contact {
        void add(double[] force);
    }

    /**
     * @param i         a particle that touches a surface
     * @param neighbour the other particle on which its force depends; -1 if there is none
     * @param curvature how fast the force turns with position (1/m)
     * @param contact   its contact force, at the state as it is varied
     * @param state     the state, whose entries of the particle are varied and restored
     * @param force     the force before contact (N), likewise
     */
    void add(int i, int neighbour, double curvature, Contact contact, double[] state, double[] force,
            ForceDerivatives derivatives) {
        int f = STRIDE * i + 3;
        vary(f, contact, force, f, size(force, f), force, byForce);
        double size = curvature > 0 ? 1 / curvature : 0;
        vary(f, contact, state, STRIDE * i, size, force, byPosition);
        vary(f, contact, state, f, size(state, f), force, byVelocity);
        derivatives.transformRow(i, byForce);
        derivatives.add(i, i, byPosition, byVelocity);
        if (neighbour >= 0) {
            vary(f, contact, state, STRIDE * neighbour, size, force, byPosition);
            derivatives.add(i, neighbour, byPosition, NONE);
        }
    }

    private static double size(double[] vector, int place) {
        double size = Vector3.at(vector, place).norm1();
        return size > 0 ? size : 1;
    }

    /**
     * Differentiates the total force on a particle, whose entries begin at f, by the three entries of an array from an
     * index on; by none if the size is 0.
     */
    private void vary(int f, Contact contact, double[] vector, int place, double size, double[] force,
            double[] result) {
        double step = STEP * size;
        Arrays.fill(result, 0);
        for (int c = 0; c < 3 && size > 0; c++) {
            double value = vector[place + c];
            for (int side = -1; side <= 1; side += 2) {
                vector[place + c] = value + side * step;
                System.arraycopy(force, f, before, 0, 3);
                contact.add(force);
                for (int row = 0; row < 3; row++) {
                    result[3 * row + c] += side / (2 * step) * force[f + row];
                }
                System.arraycopy(before, 0, force, f, 3);
            }
            vector[place + c] = value;
        }
    }
}
