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

import particles.ParticleSystem;
import particles.Rule;
import particles.law.Particles;
import particles.law.Vector3;
import particles.reactions.RestingContacts;
import particles.reactions.contact.ContactModes;
import particles.reactions.contact.ContactModes.Mode;
import particles.reactions.contact.ContactSurface;

/**
 * Collisions with planes and spheres at the end of the step (clamp), the slides' "Particle/Plane Collisions": at an
 * impact v_n' = -r v_n and v_t' = v_t. "Should back-off simulation until it's just on the plane. But usually don't
 * bother!" - this rule does not bother: after a step, a particle found below a surface is moved onto it.
 *
 * <p>It gets the speed that it had at the surface. If the normal acceleration a = delta v/deltaT is constant within the
 * step, the square of that speed is v_n&sup2; + 2 a depth, so a particle that is lifted against gravity loses speed. A
 * bounce thus multiplies the energy of the normal motion by r&sup2; and adds none. Each bounce comes late, by less than
 * deltaT; {@link ExactImpacts} finds the exact time.
 *
 * <p>A particle that would leave slower than the surface's rest speed, or slower than the speed it gained within the
 * step (a bounce too short for deltaT), stays in contact. There it slides; it sticks once it is slower than the
 * friction's threshold or has reversed within a step, if static friction can hold it. In a step in which Coulomb
 * friction may stop it, friction acts as an impulse, see {@link RestingContacts#stopWithinStep}.
 */
public final class ClampedImpacts implements Rule {
    private static final int STRIDE = Particles.STRIDE;

    private final RestingContacts contacts;
    private final ContactModes modes;
    private double[] before = {};                       // the state at the beginning of the step
    private double[] arrived = {};                      // the state at its end, before clamping
    private double[] force = {};
    private boolean forceKnown;
    private final FirstCrossing crossing = new FirstCrossing();
    private final double[] points = new double[12];
    private final double[] coefficients = new double[FirstCrossing.MOST_COEFFICIENTS];

    /** @param contacts the surfaces and the particles in contact with them */
    public ClampedImpacts(RestingContacts contacts) {
        this.contacts = contacts;
        this.modes = contacts.getModes();
    }

    @Override
    public String getName() {
        return "impacts";
    }

    /** Particles that begin on a surface with no normal velocity rest on it from the start. */
    @Override
    public void start(ParticleSystem system) {
        beforeStep(system, 0);
        double[] state = system.getOwnState();
        for (int p = 0; p < contacts.getSurfaces().size(); p++) {
            ContactSurface surface = contacts.getSurfaces().get(p);
            for (int i = 0; i < system.getParticles().count(); i++) {
                if (!system.getParticles().isFixed(i) && Math.abs(distance(surface, state, i)) <= slack(state, i)
                        && Math.abs(normalSpeed(surface, state, i)) <= surface.restSpeed()) {
                    stopAlong(normal(surface, state, i), state, i);
                    touch(p, i, state);
                }
            }
        }
        for (int i = 0; i < system.getParticles().count(); i++) {
            slideOrStick(system, i, state);
        }
    }

    private void touch(int p, int i, double[] state) {
        if (contacts.canPush(p, i, state)) {
            modes.set(p, i, Mode.SLIDING);
            modes.setWhereTouching(i, Mode.SLIDING);
        }
    }

    @Override
    public void beforeStep(ParticleSystem system, double deltaT) {
        contacts.beginStep(system);
        contacts.stopWithinStep(system, deltaT);
        before = contacts.getStepBegin();
        forceKnown = false;
    }

    @Override
    public boolean afterStep(ParticleSystem system, double deltaT) {
        if (arrived.length != system.getStateSize()) {
            arrived = new double[system.getStateSize()];
        }
        system.getState(arrived);
        boolean changed = false;
        boolean coupledChanged = false;
        for (int i = 0; i < system.getParticles().count(); i++) {
            boolean thisOne = false;
            for (int p = 0; p < contacts.getSurfaces().size() && !system.getParticles().isFixed(i); p++) {
                thisOne |= modes.get(p, i) == Mode.FREE ? collide(system, p, i, deltaT)
                        : keepInContact(system, p, i, system.getOwnState());
            }
            changed |= thisOne;
            coupledChanged |= thisOne && contacts.isCoupled(i);
        }
        if (coupledChanged) {
            contacts.putBack(system.getOwnState(), system.getTime());
            forceKnown = false;
        }
        return slideOrStickAll(system) || changed;
    }

    /**
     * Called after all particles have been moved back: a rod between two sticking particles could no longer be
     * corrected.
     */
    private boolean slideOrStickAll(ParticleSystem system) {
        double[] state = system.getOwnState();
        boolean changed = false;
        for (int i = 0; i < system.getParticles().count(); i++) {
            if (!system.getParticles().isFixed(i) && slideOrStick(system, i, state)) {
                contacts.settle(i, state);
                forceKnown &= !contacts.isCoupled(i);
                changed = true;
            }
        }
        return changed;
    }

    /** Handles a particle that was free: an impact if it is now below the surface. */
    private boolean collide(ParticleSystem system, int p, int i, double deltaT) {
        double[] state = system.getOwnState();
        ContactSurface surface = contacts.getSurfaces().get(p);
        if (!surface.obstacle().isFlat()) {
            stopFlight(surface, i, state, deltaT);
        }
        double depth = -distance(surface, state, i);
        if (depth <= 0) {
            return false;
        }
        Vector3 normal = normal(surface, state, i);
        moveAlong(normal, state, STRIDE * i, depth);
        double speed = normalSpeed(surface, state, i);
        if (speed >= 0 && !surface.obstacle().isFlat() && Math.abs(distance(surface, before, i)) <= slack(before, i)) {
            return true;                                // it has just left: below only by the error of its step
        }
        double gained = normal.dot(velocity(arrived, i).minus(velocity(before, i)));
        double atSurface = Math.sqrt(Math.max(0, speed * speed + 2 * gained / deltaT * depth));
        if (speed < 0) {
            double most = Math.max(Math.abs(gained), Math.abs(speed - normal.dot(velocity(before, i))));
            bounce(system, p, i, surface.restitution() * atSurface, most, deltaT);
        } else if (!contacts.isCoupled(i)) {
            moveAlong(normal, state, STRIDE * i + 3, atSurface - speed);
        }
        return true;
    }

    /** Lets a particle leave a surface, or rest on it if the bounce is too small for the step. */
    private void bounce(ParticleSystem system, int p, int i, double leaving, double gained, double deltaT) {
        double[] state = system.getOwnState();
        ContactSurface surface = contacts.getSurfaces().get(p);
        Vector3 normal = normal(surface, state, i);
        boolean rests = leaving <= Math.max(surface.restSpeed(), gained);
        if (contacts.isCoupled(i)) {
            contacts.strike(p, i, rests ? 0 : leaving, state);      // its rods and wires transmit the impulse
        } else if (rests) {
            stopAlong(normal, state, i);
        } else {
            moveAlong(normal, state, STRIDE * i + 3, leaving - normalSpeed(surface, state, i));
        }
        if (rests) {
            touch(p, i, state);
            keepOnOthers(system, p, i, deltaT);
        }
    }

    /**
     * Puts a particle that came to rest on surface p onto the other surfaces it touches, as at the bottom of a groove.
     * It also stays on one that it leaves so slowly that it would be back within half a step.
     */
    private void keepOnOthers(ParticleSystem system, int p, int i, double deltaT) {
        double[] state = system.getOwnState();
        if (contacts.isCoupled(i)) {
            return;
        }
        addUpForces(system, state);
        Vector3 acceleration = velocity(force, i).times(1 / system.getParticles().mass(i));
        for (int q = 0; q < contacts.getSurfaces().size(); q++) {
            ContactSurface other = contacts.getSurfaces().get(q);
            if (q != p && modes.get(q, i) != Mode.FREE) {
                double back = -normal(other, state, i).dot(acceleration) * deltaT / 2;
                if (normalSpeed(other, state, i) > Math.max(other.restSpeed(), back)) {
                    modes.set(q, i, Mode.FREE);
                }
            }
        }
        putOnAll(contacts, i, state, 0);
        forceKnown = false;
    }

    /** Handles a particle that was in contact: it may leave, hit another surface, begin to slide or stop. */
    private boolean keepInContact(ParticleSystem system, int p, int i, double[] state) {
        ContactSurface surface = contacts.getSurfaces().get(p);
        if (!surface.obstacle().isFlat()) {
            addUpForces(system, state);
            boolean leaves = contacts.pressure(p, i, state, force) < 0;
            putOn(surface, state, i);                     // removes drift by the solver's error
            if (leaves) {
                modes.set(p, i, Mode.FREE);
            }
            return leaves;
        }
        double depth = distance(surface, state, i);
        if (depth > slack(state, i)) {
            modes.set(p, i, Mode.FREE);
            return true;
        }
        if (depth < -slack(state, i)) {
            moveAlong(normal(surface, state, i), state, STRIDE * i, -depth);
            if (normalSpeed(surface, state, i) < 0) {
                stopAlong(normal(surface, state, i), state, i);
            }
            return true;
        }
        return false;
    }

    /**
     * A sticking particle begins to slide if friction cannot hold it; a sliding one that stops sticks if friction can.
     */
    private boolean slideOrStick(ParticleSystem system, int i, double[] state) {
        if (!modes.isTouching(i)) {
            return false;
        }
        Vector3 now = velocity(state, i);
        if (modes.isSticking(i)) {
            if (canHold(system, i, state)) {
                return false;
            }
            modes.setWhereTouching(i, Mode.SLIDING);
            return true;
        }
        if (!contacts.hasStopped(i, now) || !canHold(system, i, state)) {
            return false;
        }
        moveAlong(now, state, STRIDE * i + 3, -1);
        modes.setWhereTouching(i, Mode.STICKING);
        return true;
    }

    /** Evaluates the effects' forces at most once a step, and only if a particle may stop in it. */
    private boolean canHold(ParticleSystem system, int i, double[] state) {
        addUpForces(system, state);
        return contacts.holdMargin(i, state, force) >= 0;
    }

    /** Moves a particle that flew through a ball within the step back to where it entered, with its velocity there. */
    private void stopFlight(ContactSurface surface, int i, double[] state, double deltaT) {
        bezier(before, state, deltaT, i, points);
        int count = surface.obstacle().separation(points, coefficients);
        if (distance(surface, before, i) <= slack(before, i)) {
            return;                                     // it began on the surface or below, where rods had put it
        }
        double u = crossing.of(coefficients, count);
        if (!Double.isNaN(u)) {
            for (int c = 0; c < 3; c++) {
                state[STRIDE * i + c] = (1 - u) * (1 - u) * ((1 - u) * points[c] + 3 * u * points[3 + c])
                        + u * u * (3 * (1 - u) * points[6 + c] + u * points[9 + c]);
                state[STRIDE * i + 3 + c] = (1 - u) * before[STRIDE * i + 3 + c] + u * state[STRIDE * i + 3 + c];
            }
            moveAlong(normal(surface, state, i), state, STRIDE * i, -distance(surface, state, i) - slack(state, i));
        }
    }

    private void addUpForces(ParticleSystem system, double[] state) {
        if (!forceKnown) {
            if (force.length != system.getStateSize()) {
                force = new double[system.getStateSize()];
            }
            system.addUpEffects(state, system.getTime(), force);
            forceKnown = true;
        }
    }
}
