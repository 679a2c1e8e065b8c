package particles.reactions;

import java.util.Arrays;
import particles.law.Obstacle;
import particles.law.Particles;
import particles.law.Vector3;
import particles.reactions.contact.ContactModes.Mode;
import particles.reactions.contact.Friction;
import particles.reactions.contact.SlidingDirection;

/**
 * Contacts of particles on rods or wires, as additional constraint rows: the distance d of a particle from a surface,
 * with gradient N. A sticking particle has no row, since it does not move at all.
 */
final class ContactRows {
    private static final int STRIDE = Particles.STRIDE;

    private final RestingContacts contacts;
    int count;
    int[] particle = new int[4];
    int[] surface = new int[4];
    double[] normal = new double[12];
    double[] slip = new double[12];                     // minus the sliding friction for a normal force of 1 N
    double[] value = new double[4];                     // d (m)
    double[] rate = new double[4];                      // d' (m/s)
    double[] bend = new double[4];                      // contribution of the surface's curvature to d'' (m/s^2)
    private final double[] pressing = new double[3];

    ContactRows(RestingContacts contacts) {
        this.contacts = contacts;
    }

    void clear() {
        count = 0;
    }

    /** Adds a row for each surface that a particle touches. */
    void addTouching(int i, double[] state) {
        for (int p = 0; p < contacts.getSurfaces().size(); p++) {
            if (contacts.getModes().get(p, i) != Mode.FREE) {
                add(p, i, state);
            }
        }
    }

    /** Adds a row, whether the particle touches or not. */
    void add(int p, int i, double[] state) {
        if (count == particle.length) {
            particle = Arrays.copyOf(particle, 2 * count);
            surface = Arrays.copyOf(surface, 2 * count);
            normal = Arrays.copyOf(normal, 6 * count);
            slip = Arrays.copyOf(slip, 6 * count);
            value = Arrays.copyOf(value, 2 * count);
            rate = Arrays.copyOf(rate, 2 * count);
            bend = Arrays.copyOf(bend, 2 * count);
        }
        int x = STRIDE * i;
        Obstacle obstacle = contacts.getSurfaces().get(p).obstacle();
        Vector3 n = obstacle.normal(state[x], state[x + 1], state[x + 2]);
        particle[count] = i;
        surface[count] = p;
        normal[3 * count] = n.x();
        normal[3 * count + 1] = n.y();
        normal[3 * count + 2] = n.z();
        Arrays.fill(slip, 3 * count, 3 * count + 3, 0.0);
        value[count] = obstacle.distance(state[x], state[x + 1], state[x + 2]);
        double along = n.x() * state[x + 3] + n.y() * state[x + 4] + n.z() * state[x + 5];
        rate[count] = along;
        double square = state[x + 3] * state[x + 3] + state[x + 4] * state[x + 4] + state[x + 5] * state[x + 5];
        bend[count++] = obstacle.isFlat() ? 0
                : obstacle.curvature(state[x], state[x + 1], state[x + 2]) * (square - along * along);
    }

    /** The normal of row k times a vector of its particle, which begins at {@code place} + 6 i. */
    double times(int k, double[] vectors, int place) {
        int i = STRIDE * particle[k] + place;
        return normal[3 * k] * vectors[i] + normal[3 * k + 1] * vectors[i + 1] + normal[3 * k + 2] * vectors[i + 2];
    }

    /** Whether friction on any particle depends on the force, as it is at rest and about to slide, or may stop. */
    boolean isAnyAboutToMove(double[] state) {
        for (int k = 0; k < count; k++) {
            int v = STRIDE * particle[k] + 3;
            if (friction(k).law() == Friction.Law.COULOMB && (contacts.sliding().mayStop(particle[k])
                    || contacts.sliding().startsFromRest(particle[k])
                    || state[v] - rate[k] * normal[3 * k] == 0 && state[v + 1] - rate[k] * normal[3 * k + 1] == 0
                    && state[v + 2] - rate[k] * normal[3 * k + 2] == 0)) {
                return true;
            }
        }
        return false;
    }

    /**
     * Finds the sliding friction of a contact.
     *
     * @param k     the row
     * @param push  the normal force without friction (N); used only if the particle is about to move
     * @param share as for {@link SlidingDirection#find}
     * @param force the force that will move the particle, without friction (N), from entry 6 i + 3 on
     */
    void findSlip(int k, double push, double share, double[] force, double[] state) {
        int f = STRIDE * particle[k] + 3;
        SlidingDirection sliding = contacts.sliding();
        System.arraycopy(force, f, pressing, 0, 3);
        double reference = push > 0 ? push : 1;
        Vector3 across = new Vector3(normal[3 * k], normal[3 * k + 1], normal[3 * k + 2]);
        double factor = sliding.find(friction(k), across, reference, share, pressing, state, f) / reference;
        for (int c = 0; c < 3; c++) {
            slip[3 * k + c] = factor == 0 ? 0 : factor * sliding.direction[c];
        }
    }

    /**
     * The part of a particle's Coulomb friction that contact k gives.
     *
     * @param pushes the normal forces (N), from entry {@code first} on
     */
    double share(int k, double[] pushes, int first) {
        double all = 0;
        for (int j = 0; j < count; j++) {
            all += particle[j] == particle[k] ? friction(j).ofCoulomb(pushes[first + j]) : 0;
        }
        return all > 0 ? friction(k).ofCoulomb(pushes[first + k]) / all : 1;
    }

    private Friction friction(int k) {
        return contacts.getSurfaces().get(surface[k]).friction();
    }

    /** Adds the normal force and friction of row k. */
    void addForce(int k, double push, double[] force) {
        int f = STRIDE * particle[k] + 3;
        for (int c = 0; c < 3; c++) {
            force[f + c] += push * (normal[3 * k + c] - slip[3 * k + c]);
        }
    }
}
