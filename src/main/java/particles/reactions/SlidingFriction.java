package particles.reactions;

import java.util.Arrays;
import particles.ParticleSystem;
import particles.law.Particles;
import particles.law.Vector3;
import particles.reactions.Rows.Kind;
import particles.reactions.contact.Friction;

/**
 * The sliding friction of particles on surfaces: against the direction in which they slide, also if they are about to
 * start or have reversed within a step.
 */
final class SlidingFriction {
    /** A normal within this angle of the plane of others (rad) is taken to lie in it. */
    private static final double PARALLEL = 1e-6;
    /** Speeds below this, relative to the speed at the step's beginning, have no reliable direction. */
    private static final double ALMOST_STOPPED = 1e-6;
    /** What is left of a vector along surfaces is round-off below this, relative to the vector. */
    private static final double ROUNDING = 1e-14;

    /**
     * The direction that friction opposes: a tangential velocity (m/s), or the force that will move the particle (N).
     */
    private final double[] direction = new double[3];
    private final double[] beginning = new double[3];
    private final double[] axes = new double[9];        // orthonormal, of the normals of pushing surfaces
    private int surfaces;
    private double[] stepBegin = {};                    // the state at the beginning of the step
    private double[] stopping = {};                     // m/deltaT of a particle that may stop in the step, or 0 (kg/s)

    /** Records the state at the beginning of a step. */
    void beginStep(ParticleSystem system) {
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
    void stopWithinStep(int particle, double rate) {
        if (stopping.length * Particles.STRIDE != stepBegin.length) {
            stopping = new double[stepBegin.length / Particles.STRIDE];
        }
        stopping[particle] = rate;
    }

    /**
     * @param particle its index
     * @return whether friction acts on it as an impulse in the present step
     */
    boolean mayStop(int particle) {
        return particle < stopping.length && stopping[particle] > 0;
    }

    /** Forgets the state at the beginning of the step. */
    void forget() {
        stepBegin = new double[0];
        stopping = new double[0];
    }

    /** @return the state at the beginning of the step; read only */
    double[] getStepBegin() {
        return stepBegin;
    }

    /**
     * @param particle its index
     * @return whether it is at rest at the beginning of the step; if it slides, then where the force pulls it
     */
    boolean startsFromRest(int particle) {
        int v = Particles.STRIDE * particle + 3;
        return v < stepBegin.length && Vector3.at(stepBegin, v).norm1() <= RestingContacts.ROUNDING;
    }

    /** Whether two rows are contacts of one particle with surfaces. */
    private static boolean areTogether(Rows rows, int j, int k) {
        return j >= 0 && j < rows.count && rows.kind[j] == Kind.SURFACE && rows.first[j] == rows.first[k];
    }

    /**
     * Whether the friction of some contact is not a known vector times its own normal force, so that the forces have to
     * be solved without friction first: for a particle on several surfaces, or one that starts from rest or may stop.
     */
    boolean isIndirect(Rows rows, double[] state) {
        for (int r = 0; r < rows.count; r++) {
            int i = rows.first[r];
            if (isRough(rows, r) && (areTogether(rows, r - 1, r) || areTogether(rows, r + 1, r)
                    || rows.friction(r).law() == Friction.Law.COULOMB
                            && (mayStop(i) || startsFromRest(i) || isAtRest(rows, r, state)))) {
                return true;
            }
        }
        return false;
    }

    private static boolean isRough(Rows rows, int r) {
        return rows.kind[r] == Kind.SURFACE && rows.friction(r).law() != Friction.Law.NONE;
    }

    /** Whether a particle on a surface does not move along it. */
    private static boolean isAtRest(Rows rows, int r, double[] state) {
        double speed = 0;
        double along = 0;
        for (int c = 0; c < 3; c++) {
            double v = state[Particles.STRIDE * rows.first[r] + 3 + c];
            speed += Math.abs(v);
            along += Math.abs(v - rows.rate[r] * rows.gradient[6 * r + c]);
        }
        return along <= ROUNDING * speed;
    }

    /**
     * Adds the friction of a contact to {@link Rows#pull}, once for each evaluation of the rows: along all surfaces
     * that push its particle.
     *
     * @param r         the row
     * @param pushKnown whether {@link Rows#push} holds the normal forces without friction
     * @param force     the force that will move the particle, without friction (N), from entry 6 i + 3 on
     */
    void add(Rows rows, int r, boolean pushKnown, double[] force, double[] state) {
        if (!isRough(rows, r)) {
            return;
        }
        surfaces = 0;
        keepAlong(rows.gradient, 6 * r);
        double all = 0;                                 // the particle's Coulomb friction
        for (int j = 0; pushKnown && j < rows.count; j++) {
            if (areTogether(rows, j, r)) {
                all += rows.friction(j).ofCoulomb(rows.push[j]);
                if (j != r && rows.push[j] != 0) {
                    keepAlong(rows.gradient, 6 * j);
                }
            }
        }
        double push = pushKnown && rows.push[r] > 0 ? rows.push[r] : 1;
        double share = all > 0 ? rows.friction(r).ofCoulomb(rows.push[r]) / all : 1;
        double factor = find(rows.friction(r), push, share, force, state, Particles.STRIDE * rows.first[r] + 3) / push;
        for (int c = 0; c < 3 && factor != 0; c++) {
            rows.pull[6 * r + c] -= factor * direction[c];
        }
    }

    /** Lets the particle slide only along one more surface, with a normal. */
    private void keepAlong(double[] normals, int place) {
        if (surfaces == 3) {
            return;
        }
        System.arraycopy(normals, place, direction, 0, 3);
        double length = 1;
        if (surfaces > 0) {
            along(direction, 0, direction);
            length = length(direction);
        }
        if (length > PARALLEL) {
            for (int c = 0; c < 3; c++) {
                axes[3 * surfaces + c] = direction[c] / length;
            }
            surfaces++;
        }
    }

    /**
     * Finds the direction and the factor of friction. A particle that may stop within the step gets the constant force
     * that stops it at the end of the step, minus (F_t + m v_0/deltaT), or where that is more than mu N, as much of it
     * as mu N. This does not depend on the present velocity, whose direction turns the faster the slower it is, so that
     * any solver can follow it. The error is O(deltaT), as that of the time of the stop.
     *
     * @param push  the normal force (N)
     * @param share the part of the particle's Coulomb friction that this surface can give: 1 if it is the only one
     * @param force the force that would move the particle along the surface, without friction (N), from entry v on
     * @param v     the index of the particle's velocity in the state
     * @return the factor: friction is minus factor times direction
     */
    private double find(Friction law, double push, double share, double[] force, double[] state, int v) {
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
        double least = ROUNDING * (Math.abs(x) + Math.abs(y) + Math.abs(z));
        for (int a = 0; a < 3 * surfaces; a += 3) {
            double across = axes[a] * x + axes[a + 1] * y + axes[a + 2] * z;
            x -= across * axes[a];
            y -= across * axes[a + 1];
            z -= across * axes[a + 2];
        }
        boolean none = surfaces == 3 || Math.abs(x) + Math.abs(y) + Math.abs(z) <= least;
        result[0] = none ? 0 : x;
        result[1] = none ? 0 : y;
        result[2] = none ? 0 : z;
    }

    private static double length(double[] vector) {
        return Math.sqrt(vector[0] * vector[0] + vector[1] * vector[1] + vector[2] * vector[2]);
    }
}
