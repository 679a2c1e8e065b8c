package particles.reactions;

import java.util.List;
import particles.ParticleSystem;
import particles.Particles;
import particles.Reaction;
import particles.Vector3;
import particles.reactions.ContactModes.Mode;

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

    private static final int STRIDE = Particles.STRIDE;

    private final Particles particles;
    private final List<ContactPlane> planes;
    private final NormalForces normalForces;
    private final ContactModes modes;
    private double[] stepBegin = {};                    // the state where the present step began

    private final ContactPlane[] touched;               // work arrays for one particle
    private final Vector3[] normals;
    private final double[] push;
    private final double[] pressing = new double[3];
    private final double[] friction = new double[3];
    private final double[] tangent = new double[3];
    private final double[] beginning = new double[3];

    /**
     * @param particles whom the planes hold
     * @param planes    the planes
     */
    public PlaneContacts(Particles particles, List<ContactPlane> planes) {
        this.particles = particles;
        this.planes = List.copyOf(planes);
        modes = new ContactModes(particles, planes.size());
        normalForces = new NormalForces(planes.size());
        touched = new ContactPlane[planes.size()];
        normals = new Vector3[planes.size()];
        push = new double[planes.size()];
    }

    /** @return the planes, in the order in which {@link #getModes} counts them */
    public List<ContactPlane> getPlanes() {
        return planes;
    }

    /** @return who touches which plane, for rules to decide */
    public ContactModes getModes() {
        return modes;
    }

    /**
     * Notes where a step begins. Coulomb friction has the direction of the sliding and would flip with it; within a step
     * it is continued smoothly as if the sliding had not turned round, so that the step's end shows whether it did.
     *
     * @param system the system before a step
     */
    public void beginStep(ParticleSystem system) {
        if (stepBegin.length != system.getStateSize()) {
            stepBegin = new double[system.getStateSize()];
        }
        system.getState(stepBegin);
    }

    /** @return the state where the present step began, to be read only */
    public double[] getStepBegin() {
        return stepBegin;
    }

    @Override
    public String getName() {
        return "contact";
    }

    @Override
    public boolean isActive() {
        return modes.isAnyTouching();
    }

    @Override
    public boolean dependsOnVelocity() {
        return planes.stream().anyMatch(plane -> plane.friction().law() != Friction.Law.NONE);
    }

    @Override
    public void addForces(double[] state, double time, double[] force) {
        for (int i = 0; i < modes.end(); i++) {
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
        for (int i = 0; i < modes.end(); i++) {
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
        return count > 0 && length(left) <= withstood;
    }

    /** Finds push and friction for one particle; returns how many planes it touches, 0 if there is nothing to answer. */
    private int respond(int i, double[] state, double[] force) {
        if (particles.isFixed(i)) {
            return 0;
        }
        int count = 0;
        boolean sticking = true;
        for (int p = 0; p < planes.size(); p++) {
            Mode mode = modes.get(p, i);
            if (mode != Mode.FREE) {
                touched[count] = planes.get(p);
                normals[count++] = planes.get(p).plane().normal();
                sticking &= mode == Mode.STICKING;
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
        double along = length(friction);
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
        double factor = push[p] * law.coefficient();
        along(normals[p], state, v, tangent);
        if (law.law() == Friction.Law.COULOMB) {
            double speed = length(tangent);
            if (speed > 0) {
                factor /= turned(normals[p], v) ? -speed : speed;
            } else {                                    // about to move: against the force that will move it
                along(normals[p], pressing, 0, tangent);
                factor /= Math.max(factor, length(tangent));
            }
        }
        for (int c = 0; c < 3 && factor != 0; c++) {
            friction[c] -= factor * tangent[c];
        }
    }

    /** Whether the velocity along a plane, now in tangent, points back against that at the beginning of the step. */
    private boolean turned(Vector3 normal, int v) {
        if (stepBegin.length <= v) {
            return false;
        }
        along(normal, stepBegin, v, beginning);
        return tangent[0] * beginning[0] + tangent[1] * beginning[1] + tangent[2] * beginning[2] < 0;
    }

    /** The part of a vector that lies in a plane. */
    private static void along(Vector3 normal, double[] vectors, int place, double[] result) {
        double across = normal.x() * vectors[place] + normal.y() * vectors[place + 1] + normal.z() * vectors[place + 2];
        result[0] = vectors[place] - across * normal.x();
        result[1] = vectors[place + 1] - across * normal.y();
        result[2] = vectors[place + 2] - across * normal.z();
    }

    private static double length(double[] vector) {
        return Math.sqrt(vector[0] * vector[0] + vector[1] * vector[1] + vector[2] * vector[2]);
    }
}
