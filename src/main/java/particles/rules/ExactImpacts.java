package particles.rules;

import static particles.rules.ContactGeometry.bezier;
import static particles.rules.ContactGeometry.distance;
import static particles.rules.ContactGeometry.moveAlong;
import static particles.rules.ContactGeometry.normal;
import static particles.rules.ContactGeometry.normalSpeed;
import static particles.rules.ContactGeometry.putOn;
import static particles.rules.ContactGeometry.putOnAll;
import static particles.rules.ContactGeometry.slack;
import static particles.rules.ContactGeometry.stopAlong;
import static particles.rules.ContactGeometry.velocity;

import java.util.List;
import particles.EventRule;
import particles.Motion;
import particles.ParticleSystem;
import particles.law.Particles;
import particles.law.Vector3;
import particles.reactions.RestingContacts;
import particles.reactions.contact.ContactModes;
import particles.reactions.contact.ContactModes.Mode;
import particles.reactions.contact.ContactSurface;

/**
 * Collisions with planes and spheres at their exact times, by event location: the slides' "should back-off simulation
 * until it's just on the plane". At an impact v_n' = -r v_n and v_t' = v_t; a particle that would leave no faster than
 * the surface's rest speed while it is pressed on stays in contact. {@link ContactEvents} ends contact, sliding and
 * sticking at their exact times too. Particles are never lifted, so no energy is added and the solver keeps its order.
 */
public final class ExactImpacts implements EventRule {
    private static final int STRIDE = Particles.STRIDE;
    /** Round-off of a few operations, relative to the numbers compared. */
    private static final double ROUNDING = 1e-13;
    /** Relative to the size of the motion: 32 round-offs, for a solver's stages, a spring's force and a distance. */
    private static final double DEEP = 0x1p-48;

    private final RestingContacts contacts;
    private final ContactModes modes;
    private final ContactEvents contactEvents;
    private final FirstCrossing crossing = new FirstCrossing();
    private final double[] points = new double[12];
    private final double[] coefficients = new double[FirstCrossing.MOST_COEFFICIENTS];

    /** @param contacts the surfaces and the particles in contact with them */
    public ExactImpacts(RestingContacts contacts) {
        this.contacts = contacts;
        this.modes = contacts.getModes();
        this.contactEvents = new ContactEvents(contacts);
        contacts.setHoldsOn(true);
    }

    @Override
    public String getName() {
        return "impacts";
    }

    /** Particles that begin on a surface with no normal velocity rest on it from the start. */
    @Override
    public void start(ParticleSystem system) {
        double[] state = system.getOwnState();
        for (int i = 0; i < system.getParticles().count(); i++) {
            for (int p = 0; p < contacts.getSurfaces().size() && !system.getParticles().isFixed(i); p++) {
                ContactSurface surface = contacts.getSurfaces().get(p);
                if (Math.abs(distance(surface, state, i)) <= slack(state, i)
                        && Math.abs(normalSpeed(surface, state, i)) <= surface.restSpeed()) {
                    double speed = velocity(state, i).length();
                    rest(system, p, i);
                    contactEvents.stickIfSlow(system, i, speed);
                }
            }
        }
        for (int i = 0; i < system.getParticles().count(); i++) {
            contacts.settle(i, state);
        }
        contactEvents.stickOthers(system);
        contacts.beginStep(system);
    }

    @Override
    public void beforeStep(ParticleSystem system, double deltaT) {
        contacts.beginStep(system);
    }

    /**
     * Removes the solver's error that would let particles drift off a curved surface; everything else happens at
     * events. The equations do not change, and no work is recorded.
     */
    @Override
    public boolean afterStep(ParticleSystem system, double deltaT) {
        double[] state = system.getOwnState();
        for (int p = 0; p < contacts.getSurfaces().size(); p++) {
            ContactSurface surface = contacts.getSurfaces().get(p);
            for (int i = 0; !surface.obstacle().isFlat() && i < system.getParticles().count(); i++) {
                if (modes.get(p, i) != Mode.FREE) {
                    putOn(surface, state, i);
                    contacts.stopEntering(i, state);
                } else if (distance(surface, state, i) < 0 && normalSpeed(surface, state, i) >= 0
                        && !system.getParticles().isFixed(i)) {
                    moveAlong(normal(surface, state, i), state, STRIDE * i, -distance(surface, state, i));
                }
            }
        }
        return false;
    }

    @Override
    public boolean mayTurnWithin(ParticleSystem system, double time) {
        return modes.isAnyTouching() && contacts.mayStopWithin(system, time);
    }

    @Override
    public void findEvents(Motion motion, List<Event> found) {
        contactEvents.find(motion).ifPresent(found::add);
        Particles particles = motion.getSystem().getParticles();
        double size = -1;
        for (int i = 0; i < particles.count(); i++) {
            for (int p = 0; p < contacts.getSurfaces().size() && !particles.isFixed(i); p++) {
                if (modes.get(p, i) == Mode.FREE) {
                    boolean begins = Math.abs(distance(contacts.getSurfaces().get(p), motion.getStartState(), i))
                            <= slack(motion.getStartState(), i);
                    size = begins && size < 0 ? size(motion) : size;
                    lookForMeeting(p, i, motion, begins, size, found);
                }
            }
        }
    }

    /**
     * Finds when particle i first goes below a surface, on the cubic between the motion's ends. A particle that begins
     * on the surface (after a bounce, a release or a birth) has a distance of round-off size there; it meets the
     * surface again only if it goes deeper than that, by the solver's step and not only by the cubic. The cubic may dip
     * falsely: a particle released with no speed and no acceleration rises as t&sup3;, and at first the cubic's error
     * of order t&sup2; h&sup2; is larger than that.
     *
     * @param begins whether it begins on the surface
     * @param size   the length to which round-off of positions is relative (m); used if it begins on the surface
     */
    private void lookForMeeting(int p, int i, Motion motion, boolean begins, double size, List<Event> found) {
        ContactSurface surface = contacts.getSurfaces().get(p);
        double[] begin = motion.getStartState();
        double start = motion.getStartTime();
        double h = motion.getEndTime() - start;
        bezier(begin, motion.getEndState(), h, i, points);
        int count = surface.obstacle().separation(points, coefficients);
        double radius = radius(surface, begin, i);
        double below = begins ? Math.max(0, DEEP * (size + radius) - distance(surface, begin, i)) : 0;
        for (int k = 0; k < count; k++) {
            // r^2 - R^2 = (r - R) (r + R)
            coefficients[k] += surface.obstacle().isFlat() ? below : 2 * radius * below;
        }
        double u = crossing.of(coefficients, count);
        if (!Double.isNaN(u)) {
            found.add(new Impact(begins ? Math.max(start + u * h, Math.nextUp(start)) : start + u * h, p, i, below,
                    begins && !surface.obstacle().isFlat()));
        }
    }

    /** The radius of a curved surface, 0 for a plane: distances are rounded relative to it. */
    private static double radius(ContactSurface surface, double[] state, int i) {
        int x = STRIDE * i;
        return surface.obstacle().isFlat() ? 0
                : 1 / Math.abs(surface.obstacle().curvature(state[x], state[x + 1], state[x + 2]));
    }

    /**
     * The largest coordinate of any particle, or the path in this motion if that is longer (m): round-off in a spring's
     * force is relative to its length and, in a stable step, moves its ends by a few round-offs of that.
     */
    private static double size(Motion motion) {
        double h = motion.getEndTime() - motion.getStartTime();
        double size = 0;
        for (double[] state : List.of(motion.getStartState(), motion.getEndState())) {
            for (int x = 0; x < state.length; x += STRIDE) {
                for (int c = x; c < x + 3; c++) {
                    size = Math.max(size, Math.max(Math.abs(state[c]), h * Math.abs(state[c + 3])));
                }
            }
        }
        return size;
    }

    private final class Impact implements Event {
        private final double time;
        private final int p;
        private final int i;
        private final double below;
        private final boolean onlyInwards;

        Impact(double time, int p, int i, double below, boolean onlyInwards) {
            this.time = time;
            this.p = p;
            this.i = i;
            this.below = below;
            this.onlyInwards = onlyInwards;
        }

        @Override
        public double time() {
            return time;
        }

        @Override
        public double value(ParticleSystem system) {
            double above = distance(contacts.getSurfaces().get(p), system.getOwnState(), i) + below;
            return onlyInwards
                    ? Math.max(above, normalSpeed(contacts.getSurfaces().get(p), system.getOwnState(), i)) : above;
        }

        @Override
        public void act(ParticleSystem system) {
            ContactSurface surface = contacts.getSurfaces().get(p);
            double[] state = system.getOwnState();
            Vector3 normal = normal(surface, state, i);
            moveAlong(normal, state, STRIDE * i, -distance(surface, state, i));
            double speed = velocity(state, i).length();
            double approach = normalSpeed(surface, state, i);
            if (approach > 0 && !isPressedOn(system)) {
                contacts.beginStep(system);             // it leaves, and was below by a correction or round-off
                return;
            }
            double leaving = approach < 0 ? -surface.restitution() * approach : approach;   // born inside: it leaves
            if (contacts.isCoupled(i)) {
                strike(system, leaving, leaving <= surface.restSpeed(), speed);
                return;
            }
            moveAlong(normal, state, STRIDE * i + 3, leaving - approach);
            if (leaving <= surface.restSpeed()) {
                rest(system, p, i);
            }
            stayOutOfAll(ROUNDING * speed, state);
            contactEvents.stickIfSlow(system, i, speed);
            contacts.beginStep(system);
        }

        private boolean isPressedOn(ParticleSystem system) {
            modes.set(p, i, Mode.SLIDING);
            boolean pressed = contactEvents.pressure(system, p, i) > 0;
            modes.set(p, i, Mode.FREE);
            return pressed;
        }

        /** A particle on rods or wires transmits the impulse, which may lift others off. */
        private void strike(ParticleSystem system, double leaving, boolean rests, double speed) {
            contacts.strike(p, i, rests ? 0 : leaving, system.getOwnState());
            if (rests) {
                rest(system, p, i);
                contactEvents.stickIfSlow(system, i, speed);
            }
            contacts.settle(i, system.getOwnState());
            contacts.beginStep(system);
        }

        /**
         * An impulse from one surface must not push the particle into another on which it rests, but may lift it off.
         */
        private void stayOutOfAll(double rounding, double[] state) {
            contacts.stopEntering(i, state);
            for (int q = 0; q < contacts.getSurfaces().size(); q++) {
                ContactSurface other = contacts.getSurfaces().get(q);
                if (q != p && modes.get(q, i) != Mode.FREE
                        && normalSpeed(other, state, i) > Math.max(other.restSpeed(), rounding)) {
                    modes.set(q, i, Mode.FREE);
                }
            }
            putOnAll(contacts, i, state, rounding);
        }
    }

    /** Lets a particle rest on a surface if the forces press it on. */
    private void rest(ParticleSystem system, int p, int i) {
        if (!contacts.canPush(p, i, system.getOwnState())) {
            return;
        }
        stopAlong(normal(contacts.getSurfaces().get(p), system.getOwnState(), i), system.getOwnState(), i);
        modes.set(p, i, Mode.SLIDING);
        modes.setWhereTouching(i, Mode.SLIDING);
        if (contactEvents.pressure(system, p, i) <= 0) {
            modes.set(p, i, Mode.FREE);
        }
    }
}
