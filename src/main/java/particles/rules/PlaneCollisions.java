package particles.rules;

import particles.ParticleSystem;
import particles.Particles;
import particles.Rule;
import particles.Vector3;
import particles.reactions.ContactPlane;
import particles.reactions.Friction;
import particles.reactions.PlaneContacts;
import particles.reactions.PlaneContacts.Mode;

/**
 * Particles bounce off planes, the slides' "Particle/Plane Collisions": at an impact v_n' = -r v_n and v_t' = v_t. "Should
 * back-off simulation until it's just on the plane. But usually don't bother!" - this rule does not bother: a particle found
 * below the plane after a step is put onto it.
 *
 * <p>It also decides what happens where bounces get smaller and smaller. A particle that would leave slower than the
 * plane's rest speed, or slower than the speed it gained by acceleration within the step (a bounce which the step cannot
 * resolve), stays in contact. In contact it slides, or sticks once it is slower than the friction's threshold or has turned
 * round within a step, provided that static friction can hold it.
 */
public final class PlaneCollisions implements Rule {
    private static final int STRIDE = Particles.STRIDE;
    /** A particle in contact is on the plane but for rounding, relative to 1 m plus its distance from the origin. */
    private static final double ON_PLANE = 1e-9;

    private final PlaneContacts contacts;
    private double[] before = {};
    private double[] force = {};
    private boolean forceKnown;

    /** @param contacts the planes, and what touches them */
    public PlaneCollisions(PlaneContacts contacts) {
        this.contacts = contacts;
    }

    @Override
    public String getName() {
        return "plane";
    }

    /** Particles that begin on a plane and do not move away from it or into it rest on it from the start. */
    @Override
    public void start(ParticleSystem system) {
        beforeStep(system);
        double[] state = system.getOwnState();
        for (int p = 0; p < contacts.getPlanes().size(); p++) {
            ContactPlane plane = contacts.getPlanes().get(p);
            for (int i = 0; i < system.getParticles().count(); i++) {
                if (!system.getParticles().isFixed(i) && Math.abs(distance(plane, state, i)) <= slack(state, i)
                        && Math.abs(normalSpeed(plane, state, i)) <= plane.restSpeed()) {
                    stopAlong(plane.plane().normal(), state, i);
                    contacts.setMode(p, i, Mode.SLIDING);
                    slideOrStick(system, p, i, state);
                }
            }
        }
    }

    @Override
    public void beforeStep(ParticleSystem system) {
        int n = system.getStateSize();
        if (before.length != n) {
            before = new double[n];
            force = new double[n];
        }
        system.getState(before);
        forceKnown = false;
    }

    @Override
    public boolean afterStep(ParticleSystem system, double deltaT) {
        double[] state = system.getOwnState();
        boolean changed = false;
        for (int p = 0; p < contacts.getPlanes().size(); p++) {
            ContactPlane plane = contacts.getPlanes().get(p);
            for (int i = 0; i < system.getParticles().count(); i++) {
                if (system.getParticles().isFixed(i)) {
                    continue;
                }
                changed |= contacts.getMode(p, i) == Mode.FREE ? collide(system, p, plane, i, state)
                        : keepInContact(system, p, plane, i, state);
            }
        }
        return changed;
    }

    /** A particle that was free: an impact if it is below the plane now. */
    private boolean collide(ParticleSystem system, int p, ContactPlane plane, int i, double[] state) {
        double depth = distance(plane, state, i);
        if (depth >= 0) {
            return false;
        }
        Vector3 normal = plane.plane().normal();
        moveAlong(normal, state, STRIDE * i, -depth);
        double approach = normalSpeed(plane, state, i);
        if (approach < 0) {
            double leaving = -plane.restitution() * approach;
            double gained = Math.abs(approach - normalSpeed(plane, before, i));
            if (leaving <= Math.max(plane.restSpeed(), gained)) {
                stopAlong(normal, state, i);
                contacts.setMode(p, i, Mode.SLIDING);
                slideOrStick(system, p, i, state);
            } else {
                moveAlong(normal, state, STRIDE * i + 3, leaving - approach);
            }
        }
        return true;
    }

    /** A particle that was in contact: it may leave, be pressed in by another plane, begin or cease to slide. */
    private boolean keepInContact(ParticleSystem system, int p, ContactPlane plane, int i, double[] state) {
        double depth = distance(plane, state, i);
        if (depth > slack(state, i)) {
            contacts.setMode(p, i, Mode.FREE);
            return true;
        }
        boolean changed = false;
        if (depth < -slack(state, i)) {
            moveAlong(plane.plane().normal(), state, STRIDE * i, -depth);
            if (normalSpeed(plane, state, i) < 0) {
                stopAlong(plane.plane().normal(), state, i);
            }
            changed = true;
        }
        return slideOrStick(system, p, i, state) || changed;
    }

    private boolean slideOrStick(ParticleSystem system, int p, int i, double[] state) {
        ContactPlane plane = contacts.getPlanes().get(p);
        Friction friction = plane.friction();
        if (friction.law() == Friction.Law.NONE) {
            return false;
        }
        Vector3 now = along(plane.plane().normal(), state, i);
        Mode mode = contacts.getMode(p, i);
        if (mode == Mode.STICKING) {
            if (now.equals(Vector3.ZERO)) {
                return false;
            }
            contacts.setMode(p, i, Mode.SLIDING);
            return true;
        }
        Vector3 earlier = along(plane.plane().normal(), before, i);
        boolean turned = friction.law() == Friction.Law.COULOMB && now.dot(earlier) <= 0;
        if (!(turned || now.length() <= friction.threshold()) || !canHold(system, i, state)) {
            return false;
        }
        moveAlong(now, state, STRIDE * i + 3, -1);      // what is left of the velocity along the plane
        contacts.setMode(p, i, Mode.STICKING);
        return true;
    }

    /** The effects' forces are only added up in steps in which a particle may stop. */
    private boolean canHold(ParticleSystem system, int i, double[] state) {
        if (!forceKnown) {
            system.addUpEffects(state, system.getTime(), force);
            forceKnown = true;
        }
        return contacts.canHold(i, state, force);
    }

    private static double slack(double[] state, int i) {
        int x = STRIDE * i;
        return ON_PLANE * (1 + Math.abs(state[x]) + Math.abs(state[x + 1]) + Math.abs(state[x + 2]));
    }

    private static double distance(ContactPlane plane, double[] state, int i) {
        int x = STRIDE * i;
        return plane.plane().distance(state[x], state[x + 1], state[x + 2]);
    }

    private static double normalSpeed(ContactPlane plane, double[] state, int i) {
        Vector3 normal = plane.plane().normal();
        int v = STRIDE * i + 3;
        return normal.x() * state[v] + normal.y() * state[v + 1] + normal.z() * state[v + 2];
    }

    private static Vector3 along(Vector3 normal, double[] state, int i) {
        int v = STRIDE * i + 3;
        Vector3 velocity = new Vector3(state[v], state[v + 1], state[v + 2]);
        return velocity.minus(normal.times(normal.dot(velocity)));
    }

    private static void stopAlong(Vector3 normal, double[] state, int i) {
        int v = STRIDE * i + 3;
        moveAlong(normal, state, v, -(normal.x() * state[v] + normal.y() * state[v + 1] + normal.z() * state[v + 2]));
    }

    /** Adds a multiple of a direction to the three entries from place on. */
    private static void moveAlong(Vector3 direction, double[] state, int place, double amount) {
        state[place] += amount * direction.x();
        state[place + 1] += amount * direction.y();
        state[place + 2] += amount * direction.z();
    }
}
