package particles.rules;

import static particles.rules.ContactGeometry.moveAlong;
import static particles.rules.ContactGeometry.putOn;
import static particles.rules.ContactGeometry.velocity;

import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.ToDoubleFunction;
import particles.EventRule.Event;
import particles.Motion;
import particles.ParticleSystem;
import particles.law.Particles;
import particles.law.Vector3;
import particles.reactions.RestingContacts;
import particles.reactions.contact.ContactModes;
import particles.reactions.contact.ContactModes.Mode;
import particles.reactions.contact.Friction;

/**
 * Event functions for particles in contact: the contact force vanishes and the surface lets go, a sliding particle
 * stops, a sticking one breaks away. Each function is positive until its event; its sign is checked at the end of every
 * motion.
 */
final class ContactEvents {
    private static final int STRIDE = Particles.STRIDE;
    /** Round-off of a few operations, relative to a speed. */
    private static final double ROUNDING = 1e-12;
    /** The largest error of an event's time, in ulps of the clock. */
    private static final int CLOCK_ROUNDINGS = 4;

    private final RestingContacts contacts;
    private final ContactModes modes;
    private double[] force = {};

    ContactEvents(RestingContacts contacts) {
        this.contacts = contacts;
        this.modes = contacts.getModes();
    }

    /** An event of one particle: its function, its action, and the end of the motion as a first guess of the time. */
    private record Change(double time, ToDoubleFunction<ParticleSystem> function, Consumer<ParticleSystem> deed)
            implements Event {
        @Override
        public double value(ParticleSystem system) {
            return function.applyAsDouble(system);
        }

        @Override
        public boolean happensAfter() {
            return true;
        }

        @Override
        public void act(ParticleSystem system) {
            deed.accept(system);
        }
    }

    /** Finds an event function that changed its sign within the motion, not necessarily the first one. */
    Optional<Event> find(Motion motion) {
        if (!modes.isAnyTouching()) {
            return Optional.empty();
        }
        ParticleSystem system = motion.getSystem();
        addUpForces(system);
        for (int i = 0; i < system.getParticles().count(); i++) {
            if (modes.isTouching(i)) {
                Optional<Change> change = findFor(i, motion);
                if (change.isPresent()) {
                    return Optional.of(change.get());
                }
            }
        }
        return Optional.empty();
    }

    private Optional<Change> findFor(int i, Motion motion) {
        ParticleSystem system = motion.getSystem();
        double end = motion.getEndTime();
        double[] state = motion.getEndState();
        for (int p = 0; p < contacts.getSurfaces().size(); p++) {
            int surface = p;
            if (modes.get(p, i) != Mode.FREE && contacts.pressure(p, i, state, force) < 0) {
                return Optional.of(new Change(end, s -> pressure(s, surface, i), s -> letGo(s, surface, i)));
            }
        }
        if (modes.isSticking(i)) {
            return contacts.holdMargin(i, state, force) >= 0 ? Optional.empty()
                    : Optional.of(new Change(end, s -> holdMargin(s, i), s -> slide(s, i)));
        }
        Vector3 before = velocity(motion.getStartState(), i);
        double speed = before.length();
        double slow = threshold(i);
        boolean braking = slow > 0 && speed > slow * (1 + ROUNDING);
        ToDoubleFunction<ParticleSystem> moving = s -> velocity(s.getOwnState(), i).dot(before) / speed
                - (braking ? slow : 0);
        return speed == 0 || !rubs(i) || moving.applyAsDouble(system) >= 0 ? Optional.empty()
                : Optional.of(new Change(end, moving, s -> stop(s, i, speed)));
    }

    /** Ends sticking; the particle starts from rest, and friction acts against the force that moves it. */
    private void slide(ParticleSystem system, int i) {
        modes.setWhereTouching(i, Mode.SLIDING);
        contacts.beginStep(system);
    }

    /** Removes the normal velocity on a curved surface: it is the solver's error and would be taken for an impact. */
    private void letGo(ParticleSystem system, int p, int i) {
        if (!contacts.getSurfaces().get(p).obstacle().isFlat()) {
            putOn(contacts.getSurfaces().get(p), system.getOwnState(), i);
        }
        modes.set(p, i, Mode.FREE);
    }

    /** Whether friction on a particle flips when it reverses, or may hold it. */
    private boolean rubs(int i) {
        for (int p = 0; p < contacts.getSurfaces().size(); p++) {
            Friction friction = contacts.getSurfaces().get(p).friction();
            if (modes.get(p, i) != Mode.FREE && (friction.ofCoulomb(1) > 0 || friction.staticCoefficient() > 0)) {
                return true;
            }
        }
        return false;
    }

    private double threshold(int i) {
        double threshold = 0;
        for (int p = 0; p < contacts.getSurfaces().size(); p++) {
            if (modes.get(p, i) != Mode.FREE) {
                threshold = Math.max(threshold, contacts.getSurfaces().get(p).friction().threshold());
            }
        }
        return threshold;
    }

    /**
     * Handles a sliding particle that has slowed to the threshold or turned by more than a right angle within the step.
     * If it is slower than the threshold or round-off, it stops, and sticks if friction can hold it. Otherwise only the
     * direction of friction changes.
     *
     * @param speed its speed at the beginning of the motion (m/s)
     */
    private void stop(ParticleSystem system, int i, double speed) {
        addUpForces(system);
        double[] state = system.getOwnState();
        double now = velocity(state, i).length();
        double rounding = rounding(system, i, speed);
        if (now <= Math.max(rounding, threshold(i) * (1 + ROUNDING)) && contacts.holdMargin(i, state, force) >= 0) {
            moveAlong(velocity(state, i), state, STRIDE * i + 3, -1);
            modes.setWhereTouching(i, Mode.STICKING);
            contacts.settle(i, state);
            stickOthers(system);
        } else if (now <= rounding && !contacts.isCoupled(i)) {     // rods would set it moving again in either case
            moveAlong(velocity(state, i), state, STRIDE * i + 3, -1);
        }
        contacts.beginStep(system);
    }

    /** The round-off of a speed (m/s): that of the earlier speed, and acceleration times that of the clock. */
    private double rounding(ParticleSystem system, int i, double speed) {
        int f = STRIDE * i + 3;
        double acceleration = new Vector3(force[f], force[f + 1],
                force[f + 2]).length() / system.getParticles().mass(i);
        return ROUNDING * speed + CLOCK_ROUNDINGS * Math.ulp(system.getTime()) * acceleration;
    }

    /** Lets particles that are coupled to one that came to rest stick too; they have no event of their own. */
    void stickOthers(ParticleSystem system) {
        double[] state = system.getOwnState();
        for (int i = 0; i < system.getParticles().count(); i++) {
            if (contacts.isCoupled(i) && !modes.isSticking(i) && contacts.isSlow(i, state) && holdMargin(system,
                    i) >= 0) {
                moveAlong(velocity(state, i), state, STRIDE * i + 3, -1);
                modes.setWhereTouching(i, Mode.STICKING);
                contacts.settle(i, state);
            }
        }
    }

    /**
     * Lets a particle that has just come to rest on a surface stick if it hardly moves along it.
     *
     * @param speed its speed before that (m/s)
     */
    void stickIfSlow(ParticleSystem system, int i, double speed) {
        if (rubs(i) && holdMargin(system, i) >= 0) {
            stop(system, i, speed);
        }
    }

    double pressure(ParticleSystem system, int p, int i) {
        addUpForces(system);
        return contacts.pressure(p, i, system.getOwnState(), force);
    }

    private double holdMargin(ParticleSystem system, int i) {
        addUpForces(system);
        return contacts.holdMargin(i, system.getOwnState(), force);
    }

    private void addUpForces(ParticleSystem system) {
        if (force.length != system.getStateSize()) {
            force = new double[system.getStateSize()];
        }
        system.addUpEffects(system.getOwnState(), system.getTime(), force);
    }
}
