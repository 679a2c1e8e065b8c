package particles.reactions;

import java.util.List;
import particles.ForceDerivatives;
import particles.ParticleSystem;
import particles.Particles;
import particles.Reaction;
import particles.Vector3;

/**
 * The contact force on particles that rest on planes, the slides' "Particle/Plane Contact": for N . F &ge; 0 none; otherwise
 * the plane pushes back just as hard as it is pressed, lambda = -(N . F), and rubs with lambda times the friction law.
 * Several planes on one particle share the load ({@link NormalForces}). The surface of a sphere pushes by m v_t&sup2;/R less
 * where it curves away from the particle, and more where it curves towards it: (N . a) is what the circle needs, not 0.
 *
 * <p>Whether a particle touches a plane, and whether it slides or sticks there, does not change within a step:
 * {@code particles.rules.PlaneCollisions} decides it between steps. So the force is a smooth function of the state
 * while a solver works.
 */
public final class PlaneContacts implements Reaction {

    private static final int STRIDE = Particles.STRIDE;

    private final Particles particles;
    private final List<ContactPlane> planes;
    private final ContactModes modes;
    private final boolean flat;
    private boolean holdsOn;
    private final Sliding sliding = new Sliding();
    private final ContactDerivative derivative;

    private final TouchedSurfaces touched;              // by the particle that respond() looked at last
    private final Vector3[] normals;
    private final double[] push;
    private final double[] friction = new double[3];

    /**
     * @param particles whom the planes hold
     * @param planes    the planes
     */
    public PlaneContacts(Particles particles, List<ContactPlane> planes) {
        this.particles = particles;
        this.planes = List.copyOf(planes);
        modes = new ContactModes(particles, planes.size());
        touched = new TouchedSurfaces(particles, planes.size());
        normals = touched.normals;
        push = touched.push;
        flat = this.planes.stream().allMatch(plane -> plane.obstacle().isFlat());
        derivative = new ContactDerivative(planes.size());
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
        sliding.beginStep(system);
    }

    /**
     * Whether a plane holds on to a particle until a rule says that it lets go. Without that the plane stops pushing wherever
     * N . F turns positive, as on the slide; then the force has a kink there, and a step across it loses its order.
     *
     * @param holdsOn true where a rule finds the exact time of letting go
     */
    public void setHoldsOn(boolean holdsOn) {
        this.holdsOn = holdsOn;
    }

    /** @return the state where the present step began, to be read only */
    public double[] getStepBegin() {
        return sliding.getStepBegin();
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

    /** {@inheritDoc} They are known for planes; a curved surface's normal changes with the place. */
    @Override
    public boolean hasForceDerivatives() {
        return flat;
    }

    @Override
    public void addForceDerivatives(double[] state, double time, double[] force, ForceDerivatives derivatives) {
        for (int i = 0; i < modes.end(); i++) {
            int count = respond(i, state, force);
            if (count == 0) {
                continue;
            }
            derivative.begin(count, normals, push);
            if (touched.isSticking()) {
                derivative.hold();
            }
            for (int p = 0; p < count && !touched.isSticking(); p++) {
                double factor = sliding.find(touched.surfaces[p].friction(), normals[p], push[p], touched.pressing, state,
                        STRIDE * i + 3);
                derivative.rub(p, factor, sliding, touched.surfaces[p].friction().law());
            }
            derivative.add(i, derivatives);
        }
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
    public double getPower(double[] state, double time, double[] force) {
        double power = 0;
        for (int i = 0; i < modes.end(); i++) {
            int count = respond(i, state, force);
            int v = STRIDE * i + 3;
            for (int p = 0; p < count; p++) {
                power += push[p] * (normals[p].x() * state[v] + normals[p].y() * state[v + 1] + normals[p].z() * state[v + 2]);
            }
            if (count > 0) {
                power += friction[0] * state[v] + friction[1] * state[v + 1] + friction[2] * state[v + 2];
            }
        }
        return power;
    }

    @Override
    public void reindex(int[] newIndex) {
        modes.reindex(newIndex);
        sliding.forget();
    }

    /**
     * By how much static friction can hold a particle against the force on it.
     *
     * @param particle its index
     * @param state    the particles' state
     * @param force    the total force of all effects (N)
     * @return what the planes it touches withstand minus the force along them (N); negative if they cannot hold it, and
     *         where nothing presses it on
     */
    public double holdMargin(int particle, double[] state, double[] force) {
        int count = respond(particle, state, force);
        double pushed = 0;
        double withstood = 0;
        for (int p = 0; p < count; p++) {
            pushed += push[p];
            withstood += push[p] * touched.surfaces[p].friction().staticCoefficient();
        }
        return pushed > 0 ? withstood - Sliding.length(touched.unheld()) : -1;
    }

    /**
     * How hard a particle is pressed onto a plane that it touches.
     *
     * @param plane    the plane's index
     * @param particle the particle's index
     * @param state    the particles' state
     * @param force    the total force of all effects (N)
     * @return the plane's push (N); where it does not push, minus the force that pulls the particle off
     */
    public double pressure(int plane, int particle, double[] state, double[] force) {
        int count = respond(particle, state, force);
        for (int p = 0; p < count; p++) {
            if (touched.surfaces[p] == planes.get(plane)) {
                return push[p] != 0 ? push[p] : touched.needed(p, touched.unheld());
            }
        }
        return 0;
    }

    /**
     * Takes away what of a particle's velocity points into surfaces that it touches: the smallest pushes along their normals
     * after which none is entered any more. One after the other would not do where the push of one drives into the next.
     *
     * @param particle its index
     * @param state    the state, in which its velocity is changed
     */
    public void stopEntering(int particle, double[] state) {
        if (touched.gather(particle, planes, modes, state) > 0) {
            touched.answerVelocity(state, STRIDE * particle + 3);
            System.arraycopy(touched.unheld(), 0, state, STRIDE * particle + 3, 3);
        }
    }

    /** Finds push and friction for one particle; returns how many planes it touches, 0 if there is nothing to answer. */
    private int respond(int i, double[] state, double[] force) {
        if (particles.isFixed(i)) {
            return 0;
        }
        int count = touched.gather(i, planes, modes, state);
        if (count == 0) {
            return 0;
        }
        touched.answer(force, STRIDE * i + 3);
        if (holdsOn && count == 1 && push[0] == 0) {
            push[0] = touched.needed(0, touched.pressing);
        }
        friction[0] = 0;
        friction[1] = 0;
        friction[2] = 0;
        if (touched.isSticking()) {
            hold();
        } else {
            for (int p = 0; p < count; p++) {
                rub(p, state, STRIDE * i + 3);
            }
        }
        return count;
    }

    /** Static friction cancels the force along the planes. Whether it can is asked between steps: see holdMargin. */
    private void hold() {
        double[] left = touched.unheld();
        for (int c = 0; c < 3; c++) {
            friction[c] = -left[c];
        }
    }

    /** Sliding friction of one plane, against the velocity along it. */
    private void rub(int p, double[] state, int v) {
        double factor = sliding.find(touched.surfaces[p].friction(), normals[p], push[p], touched.pressing, state, v);
        for (int c = 0; c < 3 && factor != 0; c++) {
            friction[c] -= factor * sliding.direction[c];
        }
    }
}
