package particles.rules;

import particles.ParticleSystem;
import particles.law.Vector3;
import particles.reactions.ContactModes.Mode;
import particles.reactions.ContactSurface;
import particles.reactions.RestingContacts;

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
public final class ClampedImpacts extends Impacts {
    private double[] arrived = {};                      // the state at the end of the step, before clamping

    /** @param contacts the surfaces and the particles in contact with them */
    public ClampedImpacts(RestingContacts contacts) {
        super(contacts);
    }

    @Override
    public void beforeStep(ParticleSystem system, double deltaT) {
        super.beforeStep(system, deltaT);
        contacts.stopWithinStep(deltaT);
    }

    @Override
    public boolean afterStep(ParticleSystem system, double deltaT) {
        if (arrived.length != system.getStateSize()) {
            arrived = new double[system.getStateSize()];
        }
        system.getState(arrived);
        boolean changed = false;
        boolean coupledChanged = false;
        for (int i = 0; i < particles.count(); i++) {
            boolean thisOne = false;
            for (int p = 0; p < surfaces.size() && !particles.isFixed(i); p++) {
                thisOne |= modes.get(p, i) == Mode.FREE ? collide(p, i, deltaT) : keepInContact(p, i);
            }
            changed |= thisOne;
            coupledChanged |= thisOne && contacts.isCoupled(i);
        }
        if (coupledChanged) {
            contacts.putBack();
            forceKnown = false;
        }
        // last, since a rod between two sticking particles could no longer be corrected
        for (int i = 0; i < modes.end(); i++) {
            changed |= slideOrStick(i);
        }
        return changed;
    }

    /** Handles a particle that was free: an impact if it is now below the surface. */
    private boolean collide(int p, int i, double deltaT) {
        double[] state = system.getOwnState();
        double[] before = contacts.getStepBegin();
        ContactSurface surface = surfaces.get(p);
        boolean isFlat = surface.obstacle().isFlat();
        if (!isFlat) {
            stopFlight(surface, i, state, deltaT);
        }
        double depth = -surface.distance(state, i);
        if (depth <= 0) {
            return false;
        }
        Vector3 normal = surface.normal(state, i);
        lift(surface, state, i);
        double speed = surface.normalSpeed(state, i);
        if (speed >= 0 && !isFlat && isOn(surface, before, i)) {
            return true;                                // it has just left: below only by the error of its step
        }
        double gained = normal.dot(velocity(arrived, i).minus(velocity(before, i)));
        double atSurface = Math.sqrt(Math.max(0, speed * speed + 2 * gained / deltaT * depth));
        if (speed < 0) {
            double most = Math.max(Math.abs(gained), Math.abs(speed - normal.dot(velocity(before, i))));
            double leaving = surface.restitution() * atSurface;
            boolean rests = leaving <= Math.max(surface.restSpeed(), most);
            // a particle that rests stays on others where it would be back in half a step
            Vector3 pull = rests && !contacts.isCoupled(i)
                    ? velocity(forces(), i).times(deltaT / 2 / particles.mass(i)) : Vector3.ZERO;
            bounce(p, i, leaving, rests, pull);
            if (rests) {
                contacts.putOnSurfaces(i, state);
                forceKnown = false;
            }
        } else if (!contacts.isCoupled(i)) {
            moveAlong(normal, state, STRIDE * i + 3, atSurface - speed);
        }
        return true;
    }

    /** Handles a particle that was in contact: it may leave, hit another surface, begin to slide or stop. */
    private boolean keepInContact(int p, int i) {
        double[] state = system.getOwnState();
        ContactSurface surface = surfaces.get(p);
        boolean isFlat = surface.obstacle().isFlat();
        double distance = surface.distance(state, i);
        boolean leaves = isFlat ? distance > slack(state, i) : pressure(p, i) < 0;
        boolean isBelow = distance < -slack(state, i);
        if (leaves) {
            modes.set(p, i, Mode.FREE);
        }
        if (!isFlat) {
            putOn(surface, state, i);                   // removes drift by the solver's error
        } else if (isBelow) {
            lift(surface, state, i);
            if (surface.normalSpeed(state, i) < 0) {
                stopAlong(surface.normal(state, i), state, i);
            }
        }
        return leaves || isFlat && isBelow;
    }

    /**
     * A sticking particle begins to slide if friction cannot hold it; a sliding one that stops sticks if friction can.
     */
    private boolean slideOrStick(int i) {
        double[] state = system.getOwnState();
        boolean sticks = modes.isSticking(i);
        if (!modes.isTouching(i) || !sticks && !contacts.hasStopped(i, velocity(state, i))
                || holdMargin(i) >= 0 == sticks) {
            return false;
        }
        if (sticks) {
            modes.setWhereTouching(i, Mode.SLIDING);
        } else {
            stick(i, state);
        }
        return true;
    }

    /** Moves a particle that flew through a ball within the step back to where it entered, with its velocity there. */
    private void stopFlight(ContactSurface surface, int i, double[] state, double deltaT) {
        double[] before = contacts.getStepBegin();
        if (surface.distance(before, i) <= slack(before, i)) {
            return;                                     // it began on the surface or below, where rods had put it
        }
        double u = firstBelow(surface, before, state, deltaT, i, 0);
        if (!Double.isNaN(u)) {
            double[] points = crossing.points;
            for (int c = 0, x = STRIDE * i; c < 3; c++, x++) {
                state[x] = (1 - u) * (1 - u) * ((1 - u) * points[c] + 3 * u * points[3 + c])
                        + u * u * (3 * (1 - u) * points[6 + c] + u * points[9 + c]);
                state[x + 3] = (1 - u) * before[x + 3] + u * state[x + 3];
            }
            moveAlong(surface.normal(state, i), state, STRIDE * i, -surface.distance(state, i) - slack(state, i));
        }
    }
}
