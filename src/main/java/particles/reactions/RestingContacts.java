package particles.reactions;

import java.util.List;
import java.util.Optional;
import particles.ParticleSystem;
import particles.law.ForceDerivatives;
import particles.law.Particles;
import particles.law.Reaction;
import particles.law.Vector3;
import particles.reactions.contact.ContactModes;
import particles.reactions.contact.ContactResponse;
import particles.reactions.contact.ContactSurface;
import particles.reactions.contact.Friction;
import particles.reactions.contact.NormalForces;
import particles.reactions.contact.SlidingDirection;

/**
 * The contact force on particles that rest on surfaces, the slides' "Particle/Plane Contact": for N . F &ge; 0 none;
 * otherwise the surface pushes back just as hard as it is pressed, lambda = -(N . F), and rubs with lambda times the
 * friction law. Several surfaces on one particle share the load ({@link NormalForces}). The surface of a sphere pushes
 * by m v_t&sup2;/R less where it curves away from the particle, and more where it curves towards it: (N . a) is what
 * the circle needs, not 0.
 *
 * <p>Whether a particle touches a surface, and whether it slides or sticks there, does not change within a step:
 * {@code particles.rules.ClampedImpacts} decides it between steps, {@code ExactImpacts} at events that end one piece of
 * motion. So the force is a smooth function of the state while a solver works.
 */
public final class RestingContacts implements Reaction {

    private static final int STRIDE = Particles.STRIDE;

    /** What is left of a speed by the time when it is to be 0 (m/s). */
    private static final double ROUNDING = 1e-9;

    /** Solvers look beyond the end of a step, yoshida4 by a third of it, and several surfaces push harder than one. */
    private static final double STOPS = 4;

    private final List<ContactSurface> surfaces;
    private final ContactModes modes;
    private Optional<RigidConstraints> coupled = Optional.empty();
    private final SlidingDirection sliding = new SlidingDirection();
    private final ContactResponse response;

    /**
     * @param particles whom the surfaces hold
     * @param surfaces  the surfaces
     */
    public RestingContacts(Particles particles, List<ContactSurface> surfaces) {
        this.surfaces = List.copyOf(surfaces);
        modes = new ContactModes(particles, surfaces.size());
        response = new ContactResponse(particles, this.surfaces, modes, sliding);
    }

    /** @return the surfaces, in the order in which {@link #getModes} counts them */
    public List<ContactSurface> getSurfaces() {
        return surfaces;
    }

    /** @return who touches which surface, for rules to decide */
    public ContactModes getModes() {
        return modes;
    }

    /**
     * Notes where a step begins. Coulomb friction has the direction of the sliding and would flip with it; within a
     * step it is continued smoothly as if the sliding had not turned round, so that the step's end shows whether it
     * did.
     *
     * @param system the system before a step
     */
    public void beginStep(ParticleSystem system) {
        sliding.beginStep(system);
    }

    /**
     * Whether a surface holds on to a particle until a rule says that it lets go. Without that the surface stops
     * pushing wherever N . F turns positive, as on the slide; then the force has a kink there, and a step across it
     * loses its order.
     *
     * @param holdsOn true where a rule finds the exact time of letting go
     */
    public void setHoldsOn(boolean holdsOn) {
        response.setHoldsOn(holdsOn);
    }

    /** What a particle's surfaces answer, for itself. */
    ContactResponse response() {
        return response;
    }

    SlidingDirection sliding() {
        return sliding;
    }

    void coupleTo(RigidConstraints constraints) {
        coupled = Optional.of(constraints);
    }

    /**
     * @param particle its index
     * @return whether it hangs on a rod or a wire, so that a blow to it is felt by others
     */
    public boolean isCoupled(int particle) {
        return coupled.isPresent() && coupled.get().holds(particle);
    }

    /**
     * Lets a surface strike a particle that hangs on rods or wires: all that hang together change their velocities by
     * the impulses that rods and other touched surfaces pass on, without friction. What stuck slides from now on, and
     * what was lifted off touches no more.
     *
     * @param surface  the surface's index
     * @param particle the particle's index
     * @param leaving  the speed with which it leaves (m/s)
     * @param state    the state, in which velocities are changed
     */
    public void strike(int surface, int particle, double leaving, double[] state) {
        coupled.orElseThrow().strike(surface, particle, leaving, state);
    }

    /**
     * Makes the velocities of all that hang together fit each other after one of them was changed: no rod is stretched,
     * no touched surface entered, and what sticks stays where it is. Does nothing for a particle that hangs on nothing.
     *
     * @param particle one of them
     * @param state    the state, in which velocities are changed
     */
    public void settle(int particle, double[] state) {
        if (isCoupled(particle)) {
            coupled.get().settle(particle, state);
        }
    }

    /**
     * Puts all that hangs on rods and wires back onto them and onto what it touches, positions and velocities.
     *
     * @param state the state, which is changed
     * @param time  t (s), for messages
     */
    public void putBack(double[] state, double time) {
        coupled.orElseThrow().project(state, time);
    }

    /**
     * @param particle its index
     * @param state    the state
     * @return whether static friction may hold it as far as its speed goes: it touches something rough and is slower
     *         than the threshold there, or as slow as rounding
     */
    public boolean isSlow(int particle, double[] state) {
        double limit = -1;
        for (int p = 0; p < surfaces.size(); p++) {
            if (modes.get(p, particle) != ContactModes.Mode.FREE
                    && surfaces.get(p).friction().staticCoefficient() > 0) {
                limit = Math.max(limit, Math.max(ROUNDING, surfaces.get(p).friction().threshold()));
            }
        }
        int v = STRIDE * particle + 3;
        return state[v] * state[v] + state[v + 1] * state[v + 1]
                + state[v + 2] * state[v + 2] <= limit * Math.abs(limit);
    }

    /**
     * Whether Coulomb friction may turn within a time so sharply that a solver does not find the way in one step: near
     * a stop it turns as fast as the velocity, however slow that is.
     *
     * @param system the system
     * @param time   from now (s)
     * @return whether anything that slides is so slow that the forces on it could stop it well within that time
     */
    public boolean mayStopWithin(ParticleSystem system, double time) {
        double[] state = system.getOwnState();
        double[] force = new double[system.getStateSize()];
        system.addUpEffects(state, system.getTime(), force);
        for (int i = 0; i < modes.end(); i++) {
            double rubbing = 0;
            for (int p = 0; p < surfaces.size(); p++) {
                Friction friction = surfaces.get(p).friction();
                rubbing = modes.get(p, i) == ContactModes.Mode.SLIDING && friction.law() == Friction.Law.COULOMB
                        ? Math.max(rubbing, friction.coefficient()) : rubbing;
            }
            int v = STRIDE * i + 3;
            double speed = new Vector3(state[v], state[v + 1], state[v + 2]).length();
            double pull = new Vector3(force[v], force[v + 1], force[v + 2]).length() / system.getParticles().mass(i);
            if (rubbing > 0 && speed <= STOPS * time * (1 + rubbing) * pull) {
                return true;
            }
        }
        return false;
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
        return surfaces.stream().anyMatch(surface -> surface.friction().law() != Friction.Law.NONE);
    }

    @Override
    public boolean hasForceDerivatives() {
        return true;
    }

    @Override
    public void addForceDerivatives(double[] state, double time, double[] force, ForceDerivatives derivatives) {
        for (int i = 0; i < modes.end(); i++) {
            if (!isCoupled(i)) {
                response.addDerivatives(i, state, force, derivatives);
            }
        }
    }

    @Override
    public void addForces(double[] state, double time, double[] force) {
        for (int i = 0; i < modes.end(); i++) {
            if (!isCoupled(i)) {
                response.addForce(i, state, force);
            }
        }
    }

    @Override
    public double getPower(double[] state, double time, double[] force) {
        double power = coupled.isPresent() ? coupled.get().contactPower(state, time, force) : 0;
        for (int i = 0; i < modes.end(); i++) {
            power = isCoupled(i) ? power : response.addPower(power, i, state, force);
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
     * @return what the surfaces it touches withstand minus the force along them (N); negative if they cannot hold it,
     *         and where nothing presses it on
     */
    public double holdMargin(int particle, double[] state, double[] force) {
        return isCoupled(particle) ? coupled.get().holdMargin(particle, state, force)
                : response.holdMargin(particle, state, force);
    }

    /**
     * How hard a particle is pressed onto a surface that it touches.
     *
     * @param surface  the surface's index
     * @param particle the particle's index
     * @param state    the particles' state
     * @param force    the total force of all effects (N)
     * @return the surface's push (N); where it does not push, minus the force that pulls the particle off
     */
    public double pressure(int surface, int particle, double[] state, double[] force) {
        return isCoupled(particle) ? coupled.get().pressure(surface, particle, state, force)
                : response.pressure(surface, particle, state, force);
    }

    /**
     * Takes away what of a particle's velocity points into surfaces that it touches: the smallest pushes along their
     * normals after which none is entered any more. One after the other would not do where the push of one drives into
     * the next.
     *
     * @param particle its index
     * @param state    the state, in which its velocity is changed
     */
    public void stopEntering(int particle, double[] state) {
        response.stopEntering(particle, state);
    }
}
