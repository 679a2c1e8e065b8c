package particles.reactions.contact;

import java.util.List;
import particles.law.Obstacle;
import particles.law.Particles;
import particles.law.Vector3;
import particles.reactions.contact.ContactModes.Mode;

/** Work arrays for the surfaces that one particle touches and their normal forces. */
final class TouchedSurfaces {
    private static final int STRIDE = Particles.STRIDE;

    final ContactSurface[] surfaces;
    final Vector3[] normals;
    final double[] push;
    final double[] curvature;                           // 0 for a plane
    final double[] bound;                               // centripetal term: -m curvature v_t^2
    final double[] pressing = new double[3];
    private final double[] left = new double[3];
    private final Particles particles;
    private final NormalForces normalForces;
    private int count;
    private boolean sticking;

    TouchedSurfaces(Particles particles, int most) {
        this.particles = particles;
        surfaces = new ContactSurface[most];
        normals = new Vector3[most];
        push = new double[most];
        curvature = new double[most];
        bound = new double[most];
        normalForces = new NormalForces(most);
    }

    /** Collects the surfaces that particle i touches; returns their number. */
    int gather(int i, List<ContactSurface> all, ContactModes modes, double[] state) {
        count = 0;
        sticking = true;
        for (int p = 0; p < all.size(); p++) {
            Mode mode = modes.get(p, i);
            if (mode != Mode.FREE) {
                surfaces[count] = all.get(p);
                look(all.get(p).obstacle(), i, state);
                sticking &= mode == Mode.STICKING;
                count++;
            }
        }
        return count;
    }

    /** Whether all of them hold the particle by static friction. */
    boolean isSticking() {
        return sticking;
    }

    /** Computes the normal and the bound of one obstacle at particle i. */
    private void look(Obstacle obstacle, int i, double[] state) {
        int x = STRIDE * i;
        Vector3 normal = obstacle.normal(state[x], state[x + 1], state[x + 2]);
        normals[count] = normal;
        bound[count] = 0;
        curvature[count] = 0;
        if (!obstacle.isFlat()) {
            curvature[count] = obstacle.curvature(state[x], state[x + 1], state[x + 2]);
            double along = normal.x() * state[x + 3] + normal.y() * state[x + 4] + normal.z() * state[x + 5];
            double square = state[x + 3] * state[x + 3] + state[x + 4] * state[x + 4] + state[x + 5] * state[x + 5];
            bound[count] = -particles.mass(i) * curvature[count] * (square - along * along);
        }
    }

    /** Finds the normal forces for a force in three entries of an array. */
    void answer(double[] values, int place) {
        System.arraycopy(values, place, pressing, 0, 3);
        normalForces.solve(count, normals, pressing, bound, push);
    }

    /** Finds the impulses for a velocity, without centripetal terms. */
    void answerVelocity(double[] state, int v) {
        for (int p = 0; p < count; p++) {
            bound[p] = 0;
        }
        answer(state, v);
    }

    /** The force that remains after adding the normal forces. */
    double[] unheld() {
        System.arraycopy(pressing, 0, left, 0, 3);
        for (int p = 0; p < count; p++) {
            left[0] += push[p] * normals[p].x();
            left[1] += push[p] * normals[p].y();
            left[2] += push[p] * normals[p].z();
        }
        return left;
    }

    /** The normal force of surface p if it could pull as well as push. */
    double needed(int p, double[] pressing) {
        Vector3 normal = normals[p];
        return bound[p] - (normal.x() * pressing[0] + normal.y() * pressing[1] + normal.z() * pressing[2]);
    }
}
