package particles.rules;

import java.util.List;
import particles.EventRule;
import particles.ParticleSystem;
import particles.law.Particles;
import particles.law.Vector3;
import particles.reactions.ContactModes;
import particles.reactions.ContactModes.Mode;
import particles.reactions.ContactSurface;
import particles.reactions.Contacts;
import particles.reactions.RestingContacts;
import particles.reactions.Tolerances;

/**
 * Collisions with planes and spheres, the slides' "Particle/Plane Collisions": at an impact v_n' = -r v_n and v_t' =
 * v_t, and a particle that would leave too slowly stays in contact, where it slides or sticks. The subclasses differ in
 * the time at which an impact or the end of a contact is found: {@link ClampedImpacts} at the end of the step, {@link
 * ExactImpacts} where it happens.
 */
abstract class Impacts implements EventRule {
    static final int STRIDE = Particles.STRIDE;
    /** In contact, a part of a step that is longer than this may be divided (relative to deltaT). */
    private static final double SHORTEST_PART = 0x1p-6;

    final RestingContacts resting;
    final Contacts contacts;
    final ParticleSystem system;
    final Particles particles;
    final List<ContactSurface> surfaces;
    final ContactModes modes;
    double deltaT;
    boolean forceKnown;
    private double[] force = {};
    final FirstCrossing crossing = new FirstCrossing();

    Impacts(RestingContacts resting) {
        this.resting = resting;
        contacts = resting.getContacts();
        system = contacts.getSystem();
        particles = system.getParticles();
        surfaces = contacts.getSurfaces();
        modes = contacts.getModes();
    }

    @Override
    public final String getName() {
        return "impacts";
    }

    /** Particles that begin on a surface with no normal velocity rest on it from the start. */
    @Override
    public final void start(ParticleSystem system) {
        double[] state = system.getOwnState();
        double[] before = state.clone();
        beforeStep(system, 0);
        for (int i = 0; i < particles.count(); i++) {
            for (int p = 0; p < surfaces.size() && !particles.isFixed(i); p++) {
                ContactSurface surface = surfaces.get(p);
                if (isOn(surface, state, i)
                        && Math.abs(surface.normalSpeed(state, i)) <= surface.bounce().restSpeed()) {
                    rest(p, i);
                }
            }
        }
        for (int i = 0; i < modes.end(); i++) {
            stickIfSlow(i, velocity(before, i).length());
            resting.settle(i, false, state);
        }
        stickOthers();
        contacts.beginStep();
    }

    @Override
    public void beforeStep(ParticleSystem system, double deltaT) {
        this.deltaT = deltaT;
        contacts.beginStep();
        forceKnown = false;
    }

    /** {@inheritDoc} In contact: then which surfaces push and what friction stops are unknowns of a step. */
    @Override
    public boolean mayDivide(double length, double deltaT) {
        return modes.isAnyTouching() && length > SHORTEST_PART * deltaT;
    }

    /** The effects' forces in the present state. Clamped impacts evaluate them at most once in most steps. */
    final double[] forces() {
        if (!forceKnown) {
            if (force.length != system.getStateSize()) {
                force = new double[system.getStateSize()];
            }
            system.addUpEffects(system.getOwnState(), system.getTime(), force);
            forceKnown = !contacts.isHolding();
        }
        return force;
    }

    /** The speed below which a particle does not leave a surface (m/s). */
    final double restSpeed(ContactSurface surface, int i) {
        if (surface.bounce().restitution() < 1) {
            return surface.bounce().restSpeed();
        }
        return velocity(forces(), i).length() / particles.mass(i) * deltaT / 2 / Tolerances.BOUNCES;
    }

    final double pressure(int p, int i) {
        return resting.getQueries().pressure(p, i, system.getOwnState(), forces());
    }

    final double holdMargin(int i) {
        return resting.getQueries().holdMargin(i, system.getOwnState(), forces());
    }

    /** Lets a particle rest on a surface; where contact lasts until a release, only if the forces press it on. */
    final void rest(int p, int i) {
        if (resting.getImpacts().canPush(p, i, system.getOwnState())) {
            stopAlong(surfaces.get(p).normal(system.getOwnState(), i), system.getOwnState(), i);
            modes.set(p, i, Mode.SLIDING);
            modes.setWhereTouching(i, Mode.SLIDING);
            if (contacts.isHolding() && pressure(p, i) <= 0) {
                modes.set(p, i, Mode.FREE);
            }
        }
    }

    /**
     * Lets a particle that has come to rest on a rough surface stick if it hardly moves along it.
     *
     * @param speed its speed before that (m/s)
     */
    final void stickIfSlow(int i, double speed) {
        if (contacts.rubs(i) && holdMargin(i) >= 0) {
            stop(i, speed);
        }
    }

    /**
     * Handles a sliding particle that has slowed to the threshold or turned by more than a right angle within the step.
     * If it is slower than the threshold or round-off, it stops, and sticks if friction can hold it. Otherwise only the
     * direction of friction changes.
     *
     * @param speed its speed at the beginning of the motion (m/s)
     */
    final void stop(int i, double speed) {
        double[] state = system.getOwnState();
        Vector3 velocity = velocity(state, i);
        double acceleration = velocity(forces(), i).length() / particles.mass(i);
        double rounding = Tolerances.ROUNDING * speed + Tolerances.CLOCK * Math.ulp(system.getTime()) * acceleration;
        double slow = contacts.threshold(i) + rounding;
        if (velocity.length() <= slow && holdMargin(i) >= 0) {
            stick(i, state);
            stickOthers();
        } else if (velocity.length() <= rounding) {
            moveAlong(velocity, state, STRIDE * i + 3, -1);
        }
        contacts.beginStep();
    }

    final void stick(int i, double[] state) {
        moveAlong(velocity(state, i), state, STRIDE * i + 3, -1);
        modes.setWhereTouching(i, Mode.STICKING);
        resting.settle(i, true, state);
        forceKnown &= !resting.isCoupled(i);
    }

    /** Lets particles that are coupled to one that came to rest stick too; they have no event of their own. */
    final void stickOthers() {
        for (int i = 0; i < modes.end(); i++) {
            if (resting.isCoupled(i) && !modes.isSticking(i) && contacts.isSlow(i, system.getOwnState())
                    && holdMargin(i) >= 0) {
                stick(i, system.getOwnState());
            }
        }
    }

    /** When a particle goes below a surface, as a fraction of its path in {@link #crossing}; NaN if it does not. */
    final double firstBelow(ContactSurface surface, int i) {
        return crossing.into(surface.obstacle(), surface.radius().applyAsDouble(i));
    }

    /** Whether a particle is on a surface but for round-off. */
    static boolean isOn(ContactSurface surface, double[] state, int i) {
        return Math.abs(surface.distance(state, i)) <= slack(state, i);
    }

    /** The distance that a particle in contact may have from a surface by round-off (m). */
    static double slack(double[] state, int i) {
        return Tolerances.TOUCHING * (1 + Vector3.at(state, STRIDE * i).norm1());
    }

    static Vector3 velocity(double[] state, int i) {
        return Vector3.at(state, STRIDE * i + 3);
    }

    /** Moves a particle onto a surface, without changing its velocity. */
    static void lift(ContactSurface surface, double[] state, int i) {
        moveAlong(surface.normal(state, i), state, STRIDE * i, -surface.distance(state, i));
    }

    /** Moves a particle onto a surface that it touches and removes its normal velocity. */
    static void putOn(ContactSurface surface, double[] state, int i) {
        lift(surface, state, i);
        stopAlong(surface.normal(state, i), state, i);
    }

    static void stopAlong(Vector3 normal, double[] state, int i) {
        moveAlong(normal, state, STRIDE * i + 3, -normal.dot(velocity(state, i)));
    }

    /** Adds a multiple of a direction to the vector that begins at an index. */
    static void moveAlong(Vector3 direction, double[] state, int place, double amount) {
        state[place] += amount * direction.x();
        state[place + 1] += amount * direction.y();
        state[place + 2] += amount * direction.z();
    }
}
