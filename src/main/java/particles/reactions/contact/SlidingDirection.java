package particles.reactions.contact;

import java.util.Arrays;
import particles.ParticleSystem;
import particles.law.Particles;
import particles.law.Vector3;

/**
 * The direction in which a particle slides along a surface, also if it is about to start or has reversed within a step.
 */
public final class SlidingDirection {
    /** A normal within this angle of the plane of others (rad) is taken to lie in it. */
    private static final double PARALLEL = 1e-6;
    /** Speeds below this, relative to the speed at the step's beginning, have no reliable direction. */
    private static final double ALMOST_STOPPED = 1e-6;

    /**
     * The direction that friction opposes: a tangential velocity (m/s), or the force that will move the particle (N).
     */
    public final double[] direction = new double[3];
    private final double[] beginning = new double[3];
    private final double[] axes = new double[9];        // orthonormal, of the normals given to keepAlong
    private int surfaces;
    private double[] stepBegin = {};                    // the state at the beginning of the step
    private double[] stopping = {};                     // m/deltaT of a particle that may stop in the step, or 0 (kg/s)

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

    /** Lets a particle slide in any direction, until {@link #keepAlong}. */
    public void release() {
        surfaces = 0;
    }

    /** Lets the particle slide only along one more surface, with this normal. */
    public void keepAlong(Vector3 normal) {
        if (surfaces == 3) {
            return;
        }
        double[] axis = direction;
        axis[0] = normal.x();
        axis[1] = normal.y();
        axis[2] = normal.z();
        double length = 1;
        if (surfaces > 0) {
            along(axis, 0, axis);
            length = length(axis);
        }
        if (length > PARALLEL) {
            int a = 3 * surfaces++;
            axes[a] = axis[0] / length;
            axes[a + 1] = axis[1] / length;
            axes[a + 2] = axis[2] / length;
        }
    }

    /**
     * Finds the direction and the factor of friction. A particle that may stop within the step gets the constant force
     * that stops it at the end of the step, minus (F_t + m v_0/deltaT), or where that is more than mu N, as much of it
     * as mu N. This does not depend on the present velocity, whose direction turns the faster the slower it is, so that
     * any solver can follow it. The error is O(deltaT), as that of the time of the stop.
     *
     * @param push     the normal force (N)
     * @param share    the part of the particle's Coulomb friction that this surface can give: 1 if it is the only one
     * @param force    the force that would move the particle along the surface, without friction (N), from entry v on
     * @param v        the index of the particle's velocity in the state
     * @return the factor: friction is minus factor times direction; 0 for no friction
     */
    public double find(Friction law, double push, double share, double[] force, double[] state,
            int v) {
        if (law.law() == Friction.Law.NONE || !(push > 0)) {
            return 0;
        }
        double factor = push * law.coefficient();
        if (law.law() == Friction.Law.COULOMB && mayStop(v / Particles.STRIDE)) {
            return findStop(factor, share, force, v);
        }
        along(state, v, direction);
        if (law.law() == Friction.Law.COULOMB) {
            followBeginning(v);
            double speed = length(direction);
            if (speed > 0) {
                factor /= speed;
            } else {                                    // about to move: against the force that will move it
                along(force, v, direction);
                factor = share * length(direction) <= factor ? share : factor / length(direction);
            }
        }
        return factor;
    }

    private double findStop(double most, double share, double[] force, int v) {
        along(force, v, direction);
        along(stepBegin, v, beginning);
        for (int c = 0; c < 3; c++) {
            direction[c] += stopping[v / Particles.STRIDE] * beginning[c];
        }
        double needed = length(direction);
        return share * needed <= most ? share : most / needed;
    }

    /**
     * Compares the tangential velocity with that at the beginning of the step. A velocity that points back is mirrored:
     * straight back this gives the initial direction, as if the sliding had not reversed; obliquely it keeps friction
     * continuous, so that implicit solvers converge. A velocity that is only round-off is replaced by the initial one.
     */
    private void followBeginning(int v) {
        if (stepBegin.length <= v) {
            return;
        }
        if (startsFromRest(v / Particles.STRIDE)) {
            Arrays.fill(direction, 0);                  // a velocity that is mostly round-off at first
            return;
        }
        along(stepBegin, v, beginning);
        if (length(direction) < ALMOST_STOPPED * length(beginning)) {
            System.arraycopy(beginning, 0, direction, 0, 3);
            return;
        }
        double forward = direction[0] * beginning[0] + direction[1] * beginning[1] + direction[2] * beginning[2];
        double length = length(beginning);
        for (int c = 0; c < 3 && forward < 0; c++) {
            direction[c] -= 2 * forward / length * (beginning[c] / length);
        }
    }

    /** The part of a vector along all surfaces. */
    private void along(double[] vectors, int place, double[] result) {
        double x = vectors[place];
        double y = vectors[place + 1];
        double z = vectors[place + 2];
        for (int a = 0; a < 3 * surfaces; a += 3) {
            double across = axes[a] * x + axes[a + 1] * y + axes[a + 2] * z;
            x -= across * axes[a];
            y -= across * axes[a + 1];
            z -= across * axes[a + 2];
        }
        result[0] = surfaces == 3 ? 0 : x;
        result[1] = surfaces == 3 ? 0 : y;
        result[2] = surfaces == 3 ? 0 : z;
    }

    private static double length(double[] vector) {
        return Math.sqrt(vector[0] * vector[0] + vector[1] * vector[1] + vector[2] * vector[2]);
    }
}
