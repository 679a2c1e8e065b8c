package particles.reactions.contact;

import particles.ParticleSystem;
import particles.law.Vector3;

/**
 * Which way a particle slides along a surface, also where it is about to start or has just turned round within a step.
 */
public final class SlidingDirection {
    /** Relative to the speed at the beginning of a step; the direction of less is mostly rounding. */
    private static final double ALMOST_STOPPED = 1e-6;

    /** What friction opposes: a velocity along the surface (m/s), or the force that will move the particle (N). */
    public final double[] direction = new double[3];
    /** Of length 1, across the mirror in which the direction is seen after a turn; 0 before one. */
    final double[] mirrored = new double[3];
    private final double[] beginning = new double[3];
    private double[] stepBegin = {};                    // the state where the present step began
    private boolean independent;

    public void beginStep(ParticleSystem system) {
        if (stepBegin.length != system.getStateSize()) {
            stepBegin = new double[system.getStateSize()];
        }
        System.arraycopy(system.getOwnState(), 0, stepBegin, 0, stepBegin.length);
    }

    public void forget() {
        stepBegin = new double[0];
    }

    public double[] getStepBegin() {
        return stepBegin;
    }

    /** Whether the direction found last does not depend on the present velocity. */
    boolean isIndependentOfVelocity() {
        return independent;
    }

    /**
     * Finds the direction.
     *
     * @param push     how hard the surface pushes (N)
     * @param pressing the force on the particle before (N)
     * @param v        where the particle's velocity begins in the state
     * @return by what to multiply the direction for minus the friction; 0 if there is none
     */
    public double find(Friction law, Vector3 normal, double push, double[] pressing, double[] state, int v) {
        independent = false;
        mirrored[0] = 0;
        mirrored[1] = 0;
        mirrored[2] = 0;
        if (law.law() == Friction.Law.NONE || !(push > 0)) {
            return 0;
        }
        double factor = push * law.coefficient();
        along(normal, state, v, direction);
        if (law.law() == Friction.Law.COULOMB) {
            followBeginning(normal, v);
            double speed = length(direction);
            if (speed > 0) {
                factor /= speed;
            } else {                                    // about to move: against the force that will move it
                along(normal, pressing, 0, direction);
                factor /= Math.max(factor, length(direction));
                independent = true;
            }
        }
        return factor;
    }

    /**
     * Compares the velocity along a surface, now in direction, with that at the beginning of the step. What points back
     * is mirrored: straight back that is the direction of the beginning, as if the sliding had not turned round, and
     * obliquely friction stays continuous, so that implicit solvers find their stages. Where it is rounding and no
     * direction any more, the beginning's takes its place.
     */
    private void followBeginning(Vector3 normal, int v) {
        if (stepBegin.length <= v) {
            return;
        }
        along(normal, stepBegin, v, beginning);
        if (length(direction) < ALMOST_STOPPED * length(beginning)) {
            System.arraycopy(beginning, 0, direction, 0, 3);
            independent = true;
            return;
        }
        double forward = direction[0] * beginning[0] + direction[1] * beginning[1] + direction[2] * beginning[2];
        double length = length(beginning);
        for (int c = 0; c < 3 && forward < 0; c++) {
            mirrored[c] = beginning[c] / length;
            direction[c] -= 2 * forward / length * mirrored[c];
        }
    }

    /** The part of a vector that lies in a surface. */
    private static void along(Vector3 normal, double[] vectors, int place, double[] result) {
        double across = normal.x() * vectors[place] + normal.y() * vectors[place + 1] + normal.z() * vectors[place + 2];
        result[0] = vectors[place] - across * normal.x();
        result[1] = vectors[place + 1] - across * normal.y();
        result[2] = vectors[place + 2] - across * normal.z();
    }

    static double length(double[] vector) {
        return Math.sqrt(vector[0] * vector[0] + vector[1] * vector[1] + vector[2] * vector[2]);
    }
}
