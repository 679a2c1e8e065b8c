package particles.rules;

import particles.law.Particles;
import particles.law.Vector3;
import particles.reactions.RestingContacts;
import particles.reactions.contact.ContactModes.Mode;
import particles.reactions.contact.ContactSurface;

/** Distances and normals of surfaces for a particle in a flat state, and corrections of its position and velocity. */
final class ContactGeometry {
    private static final int STRIDE = Particles.STRIDE;
    /** Largest distance from a surface in contact, relative to 1 m plus the distance from the origin. */
    private static final double ON_SURFACE = 1e-9;
    /**
     * The accuracy at which {@link #putOnAll} stops: largest distance from all surfaces, relative to 1 m plus the
     * distance from the origin.
     */
    private static final double ROUNDING = 1e-13;
    private static final int MOST_SWEEPS = 100;

    private ContactGeometry() {
    }

    /** The distance that a particle in contact may have from a surface by round-off (m). */
    static double slack(double[] state, int i) {
        int x = STRIDE * i;
        return ON_SURFACE * (1 + Math.abs(state[x]) + Math.abs(state[x + 1]) + Math.abs(state[x + 2]));
    }

    static double distance(ContactSurface surface, double[] state, int i) {
        int x = STRIDE * i;
        return surface.obstacle().distance(state[x], state[x + 1], state[x + 2]);
    }

    static Vector3 normal(ContactSurface surface, double[] state, int i) {
        int x = STRIDE * i;
        return surface.obstacle().normal(state[x], state[x + 1], state[x + 2]);
    }

    /** The four B&eacute;zier points of the cubic between two states, where particle i is. */
    static void bezier(double[] begin, double[] end, double h, int i, double[] points) {
        for (int c = 0, x = STRIDE * i; c < 3; c++, x++) {
            points[c] = begin[x];
            points[3 + c] = begin[x] + h * begin[x + 3] / 3;
            points[6 + c] = end[x] - h * end[x + 3] / 3;
            points[9 + c] = end[x];
        }
    }

    /** Moves a particle onto a surface that it touches and removes its normal velocity. */
    static void putOn(ContactSurface surface, double[] state, int i) {
        moveAlong(normal(surface, state, i), state, STRIDE * i, -distance(surface, state, i));
        stopAlong(normal(surface, state, i), state, i);
    }

    /**
     * Moves a particle onto all surfaces that it touches and removes its normal velocities: one surface after the
     * other, until only round-off is left.
     *
     * @param slow speeds below this are round-off (m/s)
     */
    static void putOnAll(RestingContacts contacts, int i, double[] state, double slow) {
        double near = ROUNDING / ON_SURFACE * slack(state, i);
        boolean put = false;
        for (int sweep = 0; sweep < MOST_SWEEPS && !put; sweep++) {
            put = true;
            for (int q = 0; q < contacts.getSurfaces().size(); q++) {
                if (contacts.getModes().get(q, i) != Mode.FREE) {
                    ContactSurface surface = contacts.getSurfaces().get(q);
                    put &= Math.abs(distance(surface, state, i)) <= near
                            && Math.abs(normalSpeed(surface, state, i)) <= slow;
                    putOn(surface, state, i);
                }
            }
        }
    }

    static double normalSpeed(ContactSurface surface, double[] state, int i) {
        Vector3 normal = normal(surface, state, i);
        int v = STRIDE * i + 3;
        return normal.x() * state[v] + normal.y() * state[v + 1] + normal.z() * state[v + 2];
    }

    static Vector3 velocity(double[] state, int i) {
        int v = STRIDE * i + 3;
        return new Vector3(state[v], state[v + 1], state[v + 2]);
    }

    static void stopAlong(Vector3 normal, double[] state, int i) {
        int v = STRIDE * i + 3;
        moveAlong(normal, state, v, -(normal.x() * state[v] + normal.y() * state[v + 1] + normal.z() * state[v + 2]));
    }

    /** Adds a multiple of a direction to the three entries that begin at an index. */
    static void moveAlong(Vector3 direction, double[] state, int place, double amount) {
        state[place] += amount * direction.x();
        state[place + 1] += amount * direction.y();
        state[place + 2] += amount * direction.z();
    }
}
