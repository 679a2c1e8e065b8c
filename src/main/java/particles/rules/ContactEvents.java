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
 * What happens to particles in contact, at its time: a surface no longer presses and lets go, a sliding particle comes
 * to a stop, a sticking one breaks away. Each is a function of the state that is positive until then; whether it
 * changed its sign is looked at at the end of every motion.
 */
final class ContactEvents {
    private static final int STRIDE = Particles.STRIDE;
    /** Relative to a speed: what is less is the rounding of a few operations. */
    private static final double ROUNDING = 1e-12;
    /** How many roundings of the clock an event may be off its time. */
    private static final int CLOCK_ROUNDINGS = 4;

    private final RestingContacts contacts;
    private final ContactModes modes;
    private double[] force = {};

    ContactEvents(RestingContacts contacts) {
        this.contacts = contacts;
        this.modes = contacts.getModes();
    }

    /** An event of particle i: its function, what to do, and the end of the motion as a guess of when. */
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

    /** Something that changed its sign within the motion, if there is any; which is first shows when it is located. */
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
                    : Optional.of(new Change(end, s -> holdMargin(s, i), s -> modes.setWhereTouching(i, Mode.SLIDING)));
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

    /** The speed across a curved surface that is left here is the solver's error, and would be taken for an impact. */
    private void letGo(ParticleSystem system, int p, int i) {
        if (!contacts.getSurfaces().get(p).obstacle().isFlat()) {
            putOn(contacts.getSurfaces().get(p), system.getOwnState(), i);
        }
        modes.set(p, i, Mode.FREE);
    }

    private boolean rubs(int i) {
        for (int p = 0; p < contacts.getSurfaces().size(); p++) {
            if (modes.get(p, i) != Mode.FREE
                    && contacts.getSurfaces().get(p).friction().law() != Friction.Law.NONE) {
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
     * Sliding has slowed down to the threshold, or has turned round: by way of a stop, or by more than a right angle
     * within the step while it goes on. Only what is as slow as the threshold or as rounding stops; after that it
     * sticks, or slides off again from rest where it cannot be held. Otherwise nothing changes but the direction that
     * friction opposes.
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
        } else if (now <= rounding && !contacts.isCoupled(i)) {     // rods would give it a speed again, either way
            moveAlong(velocity(state, i), state, STRIDE * i + 3, -1);
        }
        contacts.beginStep(system);
    }

    /** A speed that is 0 but for the rounding of a larger one, and of the clock while a force acts (m/s). */
    private double rounding(ParticleSystem system, int i, double speed) {
        int f = STRIDE * i + 3;
        double acceleration = new Vector3(force[f], force[f + 1],
                force[f + 2]).length() / system.getParticles().mass(i);
        return ROUNDING * speed + CLOCK_ROUNDINGS * Math.ulp(system.getTime()) * acceleration;
    }

    /**
     * What hangs on what has come to rest may rest as well; on its own it would not be asked, since it does not slide.
     */
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
