package particles.reactions;

import java.util.List;
import particles.law.Obstacle;
import particles.law.Particles;
import particles.law.Vector3;
import particles.reactions.contact.ContactSurface;
import particles.reactions.contact.Friction;
import particles.reactions.contact.SlidingDirection;

/**
 * The contact of a particle with a surface as a constraint row: the constraint function is the distance d of the
 * particle from the surface, its gradient is the normal N. A held particle has no row, since it does not move at all.
 */
final class ContactRow {
    final int particle;
    final int surface;
    final ContactSurface on;
    private final SlidingDirection sliding;
    private final List<ContactRow> beside;              // all contacts of its particle
    Vector3 normal = Vector3.ZERO;
    Vector3 slip = Vector3.ZERO;                        // minus the sliding friction for a normal force of 1 N
    double value;                                       // d (m)
    double rate;                                        // d' (m/s)
    double push;                                        // without friction (N), for findSlip
    double bend;                                        // contribution of the surface's curvature to d'' (m/s^2)

    /** @param beside the contacts of the same particle, to which this one is added */
    ContactRow(RestingContacts contacts, int surface, int particle, List<ContactRow> beside) {
        this.particle = particle;
        this.surface = surface;
        on = contacts.getSurfaces().get(surface);
        sliding = contacts.getSliding();
        this.beside = beside;
        beside.add(this);
    }

    /**
     * Evaluates the row, without friction yet.
     *
     * @param withValue whether the distance is needed
     */
    void update(double[] state, boolean withValue) {
        Vector3 velocity = velocity(state);
        normal = on.normal(state, particle);
        rate = normal.dot(velocity);
        slip = Vector3.ZERO;
        value = withValue ? on.distance(state, particle) : 0;
        Obstacle obstacle = on.obstacle();
        if (!obstacle.isFlat()) {
            int x = Particles.STRIDE * particle;
            bend = obstacle.curvature(state[x], state[x + 1], state[x + 2]) * (velocity.dot(velocity) - rate * rate);
        }
    }

    private Vector3 velocity(double[] state) {
        return Vector3.at(state, Particles.STRIDE * particle + 3);
    }

    /** The normal times the force on the particle, or its acceleration. */
    double times(double[] force) {
        return normal.dot(velocity(force));
    }

    /**
     * Whether the friction is not a known vector times the contact's own normal force, so that the forces have to be
     * solved without friction first: for a particle on several surfaces, or one that starts from rest or may stop.
     */
    boolean isFrictionIndirect(double[] state) {
        return on.friction().law() != Friction.Law.NONE && beside.size() > 1
                || on.friction().law() == Friction.Law.COULOMB && (sliding.mayStop(particle)
                || sliding.startsFromRest(particle) || velocity(state).minus(normal.times(rate)).isZero());
    }

    /**
     * Finds the sliding friction: along all surfaces that push the particle.
     *
     * @param pushKnown whether {@link #push} holds the normal forces without friction
     * @param force     the force that will move the particle, without friction (N), from entry 6 i + 3 on
     */
    void findSlip(boolean pushKnown, double[] force, double[] state) {
        if (on.friction().law() == Friction.Law.NONE) {
            return;
        }
        sliding.release();
        sliding.keepAlong(normal);
        for (ContactRow other : beside) {
            if (pushKnown && other != this && other.push != 0) {
                sliding.keepAlong(other.normal);
            }
        }
        slip = sliding.find(on.friction(), pushKnown && push > 0 ? push : 1, pushKnown ? share() : 1, force, state,
                particle);
    }

    /** The part of the particle's Coulomb friction that this contact gives. */
    private double share() {
        double all = 0;
        for (ContactRow other : beside) {
            all += other.on.friction().ofCoulomb(other.push);
        }
        return all > 0 ? on.friction().ofCoulomb(push) / all : 1;
    }

    /** Adds the normal force and friction. */
    void addForce(double push, double[] force) {
        velocity(force).plus(normal.minus(slip).times(push)).put(force, Particles.STRIDE * particle + 3);
    }

    /** The slip times the particle's velocity. */
    double slipTimes(double[] state) {
        return slip.dot(velocity(state));
    }
}
