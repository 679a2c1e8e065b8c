package particles.reactions;

import java.util.Arrays;
import particles.law.Obstacle;
import particles.law.Particles;
import particles.law.Vector3;
import particles.reactions.contact.Friction;
import particles.reactions.contact.SlidingDirection;

/**
 * The contacts of one block's particles as constraint rows: the constraint function is the distance d of a particle
 * from a surface, its gradient is the normal N. A held particle has no row, since it does not move at all.
 */
final class ContactRows {
    private static final int STRIDE = Particles.STRIDE;

    private final RestingContacts contacts;
    int count;
    int[] particle = {};
    int[] surface = {};
    double[] normal = {};                               // 3 a row
    Friction[] friction = {};
    private Obstacle[] obstacle = {};
    double[] slip = {};                                 // minus the sliding friction for a normal force of 1 N
    double[] value = {};                                // d (m)
    double[] rate = {};                                 // d' (m/s)
    double[] push = {};                                 // without friction (N), for findSlip
    double[] bend = {};                                 // contribution of the surface's curvature to d'' (m/s^2)

    ContactRows(RestingContacts contacts) {
        this.contacts = contacts;
    }

    void clear() {
        count = 0;
    }

    /** Adds a row, whether the particle touches or not; returns its index. */
    int add(int p, int i) {
        if (count == particle.length) {
            int more = 2 * count + 1;
            particle = Arrays.copyOf(particle, more);
            surface = Arrays.copyOf(surface, more);
            normal = new double[3 * more];
            friction = Arrays.copyOf(friction, more);
            obstacle = Arrays.copyOf(obstacle, more);
            slip = new double[3 * more];
            value = new double[more];
            rate = new double[more];
            bend = new double[more];
            push = new double[more];
        }
        particle[count] = i;
        surface[count] = p;
        bend[count] = 0;
        friction[count] = contacts.getSurfaces().get(p).friction();
        obstacle[count] = contacts.getSurfaces().get(p).obstacle();
        return count++;
    }

    /**
     * Evaluates a row, without friction yet.
     *
     * @param withValue whether the distance is needed
     */
    void update(int k, double[] state, boolean withValue) {
        int x = STRIDE * particle[k];
        Obstacle obstacle = this.obstacle[k];
        Vector3 n = obstacle.normal(state[x], state[x + 1], state[x + 2]);
        double along = n.x() * state[x + 3] + n.y() * state[x + 4] + n.z() * state[x + 5];
        n.put(normal, 3 * k);
        rate[k] = along;
        Arrays.fill(slip, 3 * k, 3 * k + 3, 0);
        if (withValue) {
            value[k] = contacts.getSurfaces().get(surface[k]).distance(state, particle[k]);
        }
        if (!obstacle.isFlat()) {
            double square = state[x + 3] * state[x + 3] + state[x + 4] * state[x + 4] + state[x + 5] * state[x + 5];
            bend[k] = obstacle.curvature(state[x], state[x + 1], state[x + 2]) * (square - along * along);
        }
    }

    /** The largest curvature of the surfaces (1/m), 0 for planes. */
    double curvature(double[] state) {
        double most = 0;
        for (int k = 0; k < count; k++) {
            int x = STRIDE * particle[k];
            most = Math.max(most, Math.abs(obstacle[k].curvature(state[x], state[x + 1], state[x + 2])));
        }
        return most;
    }

    /** The normal of row k times a vector of its particle, which begins at {@code place} + 6 i. */
    double times(int k, double[] vectors, int place) {
        int i = STRIDE * particle[k] + place;
        return normal[3 * k] * vectors[i] + normal[3 * k + 1] * vectors[i + 1] + normal[3 * k + 2] * vectors[i + 2];
    }

    /**
     * Whether the friction of some contact is not a known vector times its own normal force, so that the forces have to
     * be solved without friction first: for a particle on several surfaces, or one that starts from rest or may stop.
     */
    boolean isFrictionIndirect(double[] state) {
        for (int k = 0; k < count; k++) {
            int v = STRIDE * particle[k] + 3;
            if (friction[k].law() != Friction.Law.NONE && (k > 0 && particle[k - 1] == particle[k]
                    || k + 1 < count && particle[k + 1] == particle[k])
                    || friction[k].law() == Friction.Law.COULOMB && (contacts.getSliding().mayStop(particle[k])
                    || contacts.getSliding().startsFromRest(particle[k])
                    || state[v] - rate[k] * normal[3 * k] == 0 && state[v + 1] - rate[k] * normal[3 * k + 1] == 0
                    && state[v + 2] - rate[k] * normal[3 * k + 2] == 0)) {
                return true;
            }
        }
        return false;
    }

    /**
     * Finds the sliding friction of a contact: along all surfaces that push its particle.
     *
     * @param k         the row
     * @param pushKnown whether {@link #push} holds the normal forces without friction
     * @param force     the force that will move the particle, without friction (N), from entry 6 i + 3 on
     */
    void findSlip(int k, boolean pushKnown, double[] force, double[] state) {
        if (friction[k].law() == Friction.Law.NONE) {
            return;
        }
        SlidingDirection sliding = contacts.getSliding();
        sliding.release();
        sliding.keepAlong(Vector3.at(normal, 3 * k));
        for (int j = 0; pushKnown && j < count; j++) {
            if (j != k && particle[j] == particle[k] && push[j] != 0) {
                sliding.keepAlong(Vector3.at(normal, 3 * j));
            }
        }
        int v = STRIDE * particle[k] + 3;
        boolean pushes = pushKnown && push[k] > 0;
        double factor = sliding.find(friction[k], pushes ? push[k] : 1, pushKnown ? share(k) : 1, force, state, v);
        if (pushes) {
            factor /= push[k];
        }
        for (int c = 0; c < 3; c++) {
            slip[3 * k + c] = factor == 0 ? 0 : factor * sliding.direction[c];
        }
    }

    /** The part of a particle's Coulomb friction that contact k gives. */
    private double share(int k) {
        double all = 0;
        for (int j = 0; j < count; j++) {
            all += particle[j] == particle[k] ? friction[j].ofCoulomb(push[j]) : 0;
        }
        return all > 0 ? friction[k].ofCoulomb(push[k]) / all : 1;
    }

    /** Adds the normal force and friction of row k. */
    void addForce(int k, double push, double[] force) {
        int f = STRIDE * particle[k] + 3;
        for (int c = 0; c < 3; c++) {
            force[f + c] += push * (normal[3 * k + c] - slip[3 * k + c]);
        }
    }

    /** The slip of row k times its particle's velocity. */
    double slipTimes(int k, double[] state) {
        int v = STRIDE * particle[k] + 3;
        return slip[3 * k] * state[v] + slip[3 * k + 1] * state[v + 1] + slip[3 * k + 2] * state[v + 2];
    }
}
