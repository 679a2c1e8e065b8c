package particles.rules;

import static particles.rules.ContactGeometry.distance;
import static particles.rules.ContactGeometry.moveAlong;
import static particles.rules.ContactGeometry.normalSpeed;
import static particles.rules.ContactGeometry.slack;
import static particles.rules.ContactGeometry.stopAlong;

import java.util.Optional;
import particles.EventRule;
import particles.Motion;
import particles.ParticleSystem;
import particles.Particles;
import particles.reactions.ContactModes;
import particles.reactions.ContactModes.Mode;
import particles.reactions.ContactPlane;
import particles.reactions.PlaneContacts;

/**
 * Particles bounce off planes exactly when they meet them: "should back-off simulation until it's just on the plane", done.
 * At an impact v_n' = -r v_n and v_t' = v_t; a particle that would leave no faster than the plane's rest speed while it is
 * pressed on stays in contact. {@link ContactEvents} ends contacts, sliding and sticking, at their times too. Nothing is
 * ever lifted, so that no energy is added and the solver keeps its order from impact to impact.
 */
public final class PlaneImpacts implements EventRule {
    private static final int STRIDE = Particles.STRIDE;

    private final PlaneContacts contacts;
    private final ContactModes modes;
    private final ContactEvents contactEvents;

    /** @param contacts the planes, and what touches them */
    public PlaneImpacts(PlaneContacts contacts) {
        this.contacts = contacts;
        this.modes = contacts.getModes();
        this.contactEvents = new ContactEvents(contacts);
        contacts.setHoldsOn(true);
    }

    @Override
    public String getName() {
        return "plane";
    }

    /** Particles that begin on a plane and neither leave it nor move into it rest on it from the start. */
    @Override
    public void start(ParticleSystem system) {
        double[] state = system.getOwnState();
        for (int i = 0; i < system.getParticles().count(); i++) {
            for (int p = 0; p < contacts.getPlanes().size() && !system.getParticles().isFixed(i); p++) {
                ContactPlane plane = contacts.getPlanes().get(p);
                if (Math.abs(distance(plane, state, i)) <= slack(state, i)
                        && Math.abs(normalSpeed(plane, state, i)) <= plane.restSpeed()) {
                    rest(system, p, i);
                }
            }
        }
        contacts.beginStep(system);
    }

    @Override
    public void beforeStep(ParticleSystem system) {
        contacts.beginStep(system);
    }

    /** All that this rule does happens at events. */
    @Override
    public boolean afterStep(ParticleSystem system, double deltaT) {
        return false;
    }

    @Override
    public Optional<Event> findEvent(Motion motion) {
        Particles particles = motion.getSystem().getParticles();
        Optional<Event> first = contactEvents.find(motion);
        double earliest = first.isPresent() ? first.get().time() : Double.POSITIVE_INFINITY;
        for (int i = 0; i < particles.count(); i++) {
            for (int p = 0; p < contacts.getPlanes().size() && !particles.isFixed(i); p++) {
                if (modes.get(p, i) == Mode.FREE) {
                    double time = meeting(contacts.getPlanes().get(p), i, motion);
                    if (time < earliest) {
                        earliest = time;
                        first = Optional.of(new Impact(time, p, i));
                    }
                }
            }
        }
        return first;
    }

    /** When particle i first goes below the plane, by the cubic between the motion's ends; infinite if it does not. */
    private static double meeting(ContactPlane plane, int i, Motion motion) {
        double h = motion.getEndTime() - motion.getStartTime();
        double[] begin = motion.getStartState();
        double[] end = motion.getEndState();
        double d0 = distance(plane, begin, i);
        double d1 = distance(plane, end, i);
        double rise = h * normalSpeed(plane, begin, i) / 3;
        double fall = h * normalSpeed(plane, end, i) / 3;
        if (Math.abs(d0) <= slack(begin, i)) {
            if (rise < 0) {
                return motion.getStartTime();
            }
            d0 = 0;                                     // it just left: rounding is no second impact
        }
        double u = FirstCrossing.of(d0, d0 + rise, d1 - fall, d1);
        return Double.isNaN(u) ? Double.POSITIVE_INFINITY : motion.getStartTime() + u * h;
    }

    private final class Impact implements Event {
        private final double time;
        private final int p;
        private final int i;

        Impact(double time, int p, int i) {
            this.time = time;
            this.p = p;
            this.i = i;
        }

        @Override
        public double time() {
            return time;
        }

        @Override
        public double value(ParticleSystem system) {
            return distance(contacts.getPlanes().get(p), system.getOwnState(), i);
        }

        @Override
        public void act(ParticleSystem system) {
            ContactPlane plane = contacts.getPlanes().get(p);
            double[] state = system.getOwnState();
            moveAlong(plane.plane().normal(), state, STRIDE * i, -distance(plane, state, i));
            double approach = normalSpeed(plane, state, i);
            double leaving = -plane.restitution() * approach;
            moveAlong(plane.plane().normal(), state, STRIDE * i + 3, Math.max(0, leaving) - approach);
            if (leaving <= plane.restSpeed()) {
                rest(system, p, i);
            }
            stayOutOfOthers(state);
            contacts.beginStep(system);
        }

        /** A push by one plane must not drive the particle into another one on which it rests. */
        private void stayOutOfOthers(double[] state) {
            for (int q = 0; q < contacts.getPlanes().size(); q++) {
                ContactPlane other = contacts.getPlanes().get(q);
                if (modes.get(q, i) != Mode.FREE && normalSpeed(other, state, i) != 0) {
                    if (normalSpeed(other, state, i) < 0) {
                        stopAlong(other.plane().normal(), state, i);
                    } else if (q != p) {
                        modes.set(q, i, Mode.FREE);
                    }
                }
            }
        }
    }

    /** Lets a particle stay on a plane if it is pressed on; then it may stick as well. */
    private void rest(ParticleSystem system, int p, int i) {
        double[] state = system.getOwnState();
        stopAlong(contacts.getPlanes().get(p).plane().normal(), state, i);
        modes.set(p, i, Mode.SLIDING);
        modes.setWhereTouching(i, Mode.SLIDING);
        if (contactEvents.pressure(system, p, i) > 0) {
            contactEvents.stickIfSlow(system, i);
        } else {
            modes.set(p, i, Mode.FREE);
        }
    }
}
