package particles.reactions.contact;

import java.util.Arrays;
import particles.ParticleSystem;
import particles.law.Particles;
import particles.law.Vector3;

/**
 * The direction in which a particle slides along a surface, also if it is about to start or has reversed within a step.
 */
public final class SlidingDirection {
    /** Speeds below this, relative to the speed at the step's beginning, have no reliable direction. */
    private static final double ALMOST_STOPPED = 1e-6;

    /**
     * The direction that friction opposes: a tangential velocity (m/s), or the force that will move the particle (N).
     */
    public final double[] direction = new double[3];
    /** Unit normal of the mirror used after a reversal; 0 if there was none. */
    final double[] mirrored = new double[3];
    private final double[] beginning = new double[3];
    private double[] stepBegin = {};                    // the state at the beginning of the step
    private double[] stopping = {};                     // m/deltaT of a particle that may stop in the step, or 0 (kg/s)
    private boolean independent;
    private boolean towardsStop;
    private boolean stops;

    /** Records the state at the beginning of a step. */
    public void beginStep(ParticleSystem system) {
        if (stepBegin.length != system.getStateSize()) {
            stepBegin = new double[system.getStateSize()];
        }
        System.arraycopy(system.getOwnState(), 0, stepBegin, 0, stepBegin.length);
        Arrays.fill(stopping, 0);
    }

    /**
     * Lets friction act on a particle as an impulse over the step that begins, see {@link #find}.
     *
     * @param particle its index
     * @param rate     its mass divided by the length of the step (kg/s)
     */
    public void stopWithinStep(int particle, double rate) {
        if (stopping.length * Particles.STRIDE != stepBegin.length) {
            stopping = new double[stepBegin.length / Particles.STRIDE];
        }
        stopping[particle] = rate;
    }

    /**
     * @param particle its index
     * @return whether friction acts on it as an impulse in the present step
     */
    public boolean mayStop(int particle) {
        return particle < stopping.length && stopping[particle] > 0;
    }

    /** Forgets the state at the beginning of the step. */
    public void forget() {
        stepBegin = new double[0];
        stopping = new double[0];
    }

    /** @return the state at the beginning of the step; read only */
    public double[] getStepBegin() {
        return stepBegin;
    }

    /**
     * @param particle its index
     * @return whether it is at rest at the beginning of the step; if it slides, then where the force pulls it
     */
    public boolean startsFromRest(int particle) {
        int v = Particles.STRIDE * particle + 3;
        return v < stepBegin.length && stepBegin[v] == 0 && stepBegin[v + 1] == 0 && stepBegin[v + 2] == 0;
    }

    /** Whether the last direction does not depend on the present velocity. */
    boolean isIndependentOfVelocity() {
        return independent;
    }

    /** Whether the last friction was that of an impulse over the step. */
    boolean isTowardsStop() {
        return towardsStop;
    }

    /** Whether that is strong enough for a stop. */
    boolean stops() {
        return stops;
    }

    /**
     * Finds the direction and the factor of friction. A particle that may stop within the step gets the constant force
     * that stops it at the end of the step, minus (F_t + m v_0/deltaT), or where that is more than mu N, as much of it
     * as mu N. This does not depend on the present velocity, whose direction turns the faster the slower it is, so that
     * any solver can follow it. The error is O(deltaT), as that of the time of the stop.
     *
     * @param push     the normal force (N)
     * @param share    the part of the particle's Coulomb friction that this surface can give: 1 if it is the only one
     * @param pressing the force that would move the particle along the surface, without friction (N)
     * @param v        the index of the particle's velocity in the state
     * @return the factor: friction is minus factor times direction; 0 for no friction
     */
    public double find(Friction law, Vector3 normal, double push, double share, double[] pressing, double[] state,
            int v) {
        independent = false;
        towardsStop = false;
        mirrored[0] = 0;
        mirrored[1] = 0;
        mirrored[2] = 0;
        if (law.law() == Friction.Law.NONE || !(push > 0)) {
            return 0;
        }
        double factor = push * law.coefficient();
        if (law.law() == Friction.Law.COULOMB && mayStop(v / Particles.STRIDE)) {
            return findStop(factor, share, normal, pressing, v);
        }
        along(normal, state, v, direction);
        if (law.law() == Friction.Law.COULOMB) {
            followBeginning(normal, v);
            double speed = length(direction);
            if (speed > 0) {
                factor /= speed;
            } else {                                    // about to move: against the force that will move it
                along(normal, pressing, 0, direction);
                factor = share * length(direction) <= factor ? share : factor / length(direction);
                independent = true;
            }
        }
        return factor;
    }

    private double findStop(double most, double share, Vector3 normal, double[] pressing, int v) {
        along(normal, pressing, 0, direction);
        along(normal, stepBegin, v, beginning);
        for (int c = 0; c < 3; c++) {
            direction[c] += stopping[v / Particles.STRIDE] * beginning[c];
        }
        double needed = length(direction);
        independent = true;
        towardsStop = true;
        stops = share * needed <= most;
        return stops ? share : most / needed;
    }

    /**
     * Compares the tangential velocity with that at the beginning of the step. A velocity that points back is mirrored:
     * straight back this gives the initial direction, as if the sliding had not reversed; obliquely it keeps friction
     * continuous, so that implicit solvers converge. A velocity that is only round-off is replaced by the initial one.
     */
    private void followBeginning(Vector3 normal, int v) {
        if (stepBegin.length <= v) {
            return;
        }
        if (startsFromRest(v / Particles.STRIDE)) {
            Arrays.fill(direction, 0);                  // a velocity that is mostly round-off at first
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

    /** The tangential part of a vector. */
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
