package particles.reactions;

import java.util.Arrays;
import java.util.List;
import particles.Particles;
import particles.Reaction;
import particles.Vector3;

/**
 * The contact force on particles that rest on planes, the slides' "Particle/Plane Contact": for N . F &ge; 0 none; otherwise
 * the plane pushes back just as hard as it is pressed, lambda = -(N . F), and rubs with lambda times the friction law.
 * Several planes on one particle share the load ({@link NormalForces}).
 *
 * <p>Whether a particle touches a plane, and whether it slides or sticks there, does not change within a step:
 * {@code particles.rules.PlaneCollisions} decides it between steps. So the force is a smooth function of the state
 * while a solver works.
 */
public final class PlaneContacts implements Reaction {

    /** What a particle does at a plane. */
    public enum Mode {
        /** It does not touch. */
        FREE,
        /** It touches and slides, or would if it moved. */
        SLIDING,
        /** It touches and static friction holds it as long as it is strong enough. */
        STICKING
    }

    private static final int STRIDE = Particles.STRIDE;

    private final Particles particles;
    private final List<ContactPlane> planes;
    private final NormalForces normalForces;
    private Mode[][] modes = {};                        // by particle, then plane; null for particles that touch nothing
    private int touching;

    private final ContactPlane[] touched;               // work arrays for one particle
    private final Vector3[] normals;
    private final double[] push;
    private final double[] pressing = new double[3];
    private final double[] friction = new double[3];

    /**
     * @param particles whom the planes hold
     * @param planes    the planes
     */
    public PlaneContacts(Particles particles, List<ContactPlane> planes) {
        this.particles = particles;
        this.planes = List.copyOf(planes);
        normalForces = new NormalForces(planes.size());
        touched = new ContactPlane[planes.size()];
        normals = new Vector3[planes.size()];
        push = new double[planes.size()];
    }

    /** @return the planes, in the order in which {@link #getMode} counts them */
    public List<ContactPlane> getPlanes() {
        return planes;
    }

    /**
     * @param plane    index of a plane
     * @param particle index of a particle
     * @return what the particle does at the plane
     */
    public Mode getMode(int plane, int particle) {
        return particle < modes.length && modes[particle] != null ? modes[particle][plane] : Mode.FREE;
    }

    /**
     * @param plane    index of a plane
     * @param particle index of a particle
     * @param mode     what it does there from now on
     */
    public void setMode(int plane, int particle, Mode mode) {
        Mode before = getMode(plane, particle);
        if (before == mode) {
            return;
        }
        if (modes.length < particles.count()) {
            modes = Arrays.copyOf(modes, particles.count());
        }
        if (modes[particle] == null) {
            modes[particle] = new Mode[planes.size()];
            Arrays.fill(modes[particle], Mode.FREE);
        }
        modes[particle][plane] = mode;
        touching += (mode == Mode.FREE ? 0 : 1) - (before == Mode.FREE ? 0 : 1);
    }

    @Override
    public String getName() {
        return "contact";
    }

    @Override
    public boolean isActive() {
        return touching > 0;
    }

    @Override
    public boolean dependsOnVelocity() {
        return planes.stream().anyMatch(plane -> plane.friction().law() != Friction.Law.NONE);
    }

    @Override
    public void addForces(double[] state, double time, double[] force) {
        for (int i = 0; i < modes.length; i++) {
            int count = respond(i, state, force);
            if (count == 0) {
                continue;
            }
            int f = STRIDE * i + 3;
            for (int p = 0; p < count; p++) {
                force[f] += push[p] * normals[p].x();
                force[f + 1] += push[p] * normals[p].y();
                force[f + 2] += push[p] * normals[p].z();
            }
            force[f] += friction[0];
            force[f + 1] += friction[1];
            force[f + 2] += friction[2];
        }
    }

    @Override
    public double getDissipatedPower(double[] state, double time, double[] force) {
        double power = 0;
        for (int i = 0; i < modes.length; i++) {
            if (respond(i, state, force) > 0) {
                int v = STRIDE * i + 3;
                power -= friction[0] * state[v] + friction[1] * state[v + 1] + friction[2] * state[v + 2];
            }
        }
        return power;
    }

    /**
     * Whether static friction can hold a particle against the force on it.
     *
     * @param particle its index
     * @param state    the particles' state
     * @param force    the total force of all effects (N)
     * @return true if the force along the planes it touches does not exceed what they withstand
     */
    public boolean canHold(int particle, double[] state, double[] force) {
        int count = respond(particle, state, force);
        double withstood = 0;
        double[] left = pressing.clone();
        for (int p = 0; p < count; p++) {
            left[0] += push[p] * normals[p].x();
            left[1] += push[p] * normals[p].y();
            left[2] += push[p] * normals[p].z();
            withstood += push[p] * touched[p].friction().staticCoefficient();
        }
        double along = Math.sqrt(left[0] * left[0] + left[1] * left[1] + left[2] * left[2]);
        return count > 0 && along <= withstood;
    }

    /** Finds push and friction for one particle; returns how many planes it touches, 0 if there is nothing to answer. */
    private int respond(int i, double[] state, double[] force) {
        if (i >= modes.length || modes[i] == null || particles.isFixed(i)) {
            return 0;
        }
        int count = 0;
        boolean sticking = true;
        for (int p = 0; p < planes.size(); p++) {
            if (modes[i][p] != Mode.FREE) {
                touched[count] = planes.get(p);
                normals[count++] = planes.get(p).plane().normal();
                sticking &= modes[i][p] == Mode.STICKING;
            }
        }
        if (count == 0) {
            return 0;
        }
        System.arraycopy(force, STRIDE * i + 3, pressing, 0, 3);
        normalForces.solve(count, normals, pressing, push);
        friction[0] = 0;
        friction[1] = 0;
        friction[2] = 0;
        if (sticking) {
            hold(count);
        } else {
            for (int p = 0; p < count; p++) {
                rub(p, state, STRIDE * i + 3);
            }
        }
        return count;
    }

    /** Static friction: cancels the force along the planes, or resists with what sliding friction has. */
    private void hold(int count) {
        double withstood = 0;
        double sliding = 0;
        System.arraycopy(pressing, 0, friction, 0, 3);
        for (int p = 0; p < count; p++) {
            friction[0] += push[p] * normals[p].x();
            friction[1] += push[p] * normals[p].y();
            friction[2] += push[p] * normals[p].z();
            Friction law = touched[p].friction();
            withstood += push[p] * law.staticCoefficient();
            sliding += law.law() == Friction.Law.COULOMB ? push[p] * law.coefficient() : 0;
        }
        double along = Math.sqrt(friction[0] * friction[0] + friction[1] * friction[1] + friction[2] * friction[2]);
        double part = along <= withstood ? 1 : Math.min(1, sliding / along);
        for (int c = 0; c < 3; c++) {
            friction[c] *= -part;
        }
    }

    /** Sliding friction of one plane, against the velocity along it. */
    private void rub(int p, double[] state, int v) {
        Friction law = touched[p].friction();
        if (law.law() == Friction.Law.NONE || push[p] == 0) {
            return;
        }
        Vector3 normal = normals[p];
        double vn = normal.x() * state[v] + normal.y() * state[v + 1] + normal.z() * state[v + 2];
        double tx = state[v] - vn * normal.x();
        double ty = state[v + 1] - vn * normal.y();
        double tz = state[v + 2] - vn * normal.z();
        double factor = push[p] * law.coefficient();
        if (law.law() == Friction.Law.COULOMB) {
            double speed = Math.sqrt(tx * tx + ty * ty + tz * tz);
            factor = speed > 0 ? factor / speed : 0;
        }
        friction[0] -= factor * tx;
        friction[1] -= factor * ty;
        friction[2] -= factor * tz;
    }
}
