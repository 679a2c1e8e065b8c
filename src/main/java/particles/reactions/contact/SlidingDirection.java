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

    private final Vector3[] axes = new Vector3[3];      // orthonormal, of the normals given to keepAlong
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
        Vector3 axis = along(normal);
        double length = surfaces == 0 ? 1 : length(axis);
        if (length > PARALLEL) {
            axes[surfaces++] = over(axis, length);
        }
    }

    /**
     * Finds the friction of a surface. A particle that may stop within the step gets the constant force that stops it
     * at the end of the step, minus (F_t + m v_0/deltaT), or where that is more than mu N, as much of it as mu N. This
     * does not depend on the present velocity, whose direction turns the faster the slower it is, so that any solver
     * can follow it. The error is O(deltaT), as that of the time of the stop.
     *
     * @param law      the friction of the surface
     * @param push     the normal force (N), positive
     * @param share    the part of the particle's Coulomb friction that this surface can give: 1 if it is the only one
     * @param force    the force that would move the particle along the surface, without friction (N)
     * @param particle its index
     * @return minus the friction, for a normal force of 1 N
     */
    public Vector3 find(Friction law, double push, double share, double[] force, double[] state, int particle) {
        int v = Particles.STRIDE * particle + 3;
        Vector3 direction = along(Vector3.at(state, v));
        double factor = push * law.coefficient();
        if (law.law() == Friction.Law.COULOMB) {
            boolean stops = mayStop(particle);
            direction = followBeginning(direction, particle);
            double speed = length(direction);
            if (!stops && speed > 0) {
                factor /= speed;
            } else {                                    // against the force that will move it, or that stops it
                direction = along(Vector3.at(force, v));
                if (stops) {
                    direction = direction.plus(along(Vector3.at(stepBegin, v)).times(stopping[particle]));
                }
                double needed = length(direction);
                factor = share * needed <= factor ? share : factor / needed;
            }
        }
        factor /= push;
        return factor == 0 ? Vector3.ZERO : direction.times(factor);
    }

    /**
     * Compares the tangential velocity with that at the beginning of the step. A velocity that points back is mirrored:
     * straight back this gives the initial direction, as if the sliding had not reversed; obliquely it keeps friction
     * continuous, so that implicit solvers converge. A velocity that is only round-off is replaced by the initial one.
     */
    private Vector3 followBeginning(Vector3 velocity, int particle) {
        int v = Particles.STRIDE * particle + 3;
        if (stepBegin.length <= v) {
            return velocity;
        }
        if (startsFromRest(particle)) {
            return Vector3.ZERO;                        // a velocity that is mostly round-off at first
        }
        Vector3 beginning = along(Vector3.at(stepBegin, v));
        double length = length(beginning);
        if (length(velocity) < ALMOST_STOPPED * length) {
            return beginning;
        }
        double forward = velocity.dot(beginning);
        return forward < 0 ? velocity.minus(over(beginning, length).times(2 * forward / length)) : velocity;
    }

    /** The part of a vector along all surfaces. */
    private Vector3 along(Vector3 vector) {
        Vector3 along = surfaces == axes.length ? Vector3.ZERO : vector;
        for (int a = 0; a < surfaces; a++) {
            along = along.minus(axes[a].times(axes[a].dot(along)));
        }
        return along;
    }

    private static Vector3 over(Vector3 vector, double divisor) {
        return new Vector3(vector.x() / divisor, vector.y() / divisor, vector.z() / divisor);
    }

    private static double length(Vector3 vector) {
        return Math.sqrt(vector.dot(vector));
    }
}
