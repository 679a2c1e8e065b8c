package particles.reactions;

import java.util.Optional;
import particles.law.Particles;
import particles.law.Scales;
import particles.law.Scales.Skin;
import particles.law.Vector3;
import particles.reactions.ContactSurface.Friction;
import particles.reactions.Row.Kind;

/**
 * The sliding friction of particles on surfaces: against the direction in which they slide, also if they are about to
 * start or have reversed within a step. {@link Scales} make it depend on the direction.
 */
final class SlidingFriction {
    private final Vector3[] axes = new Vector3[3];      // orthonormal, of the normals of pushing surfaces
    private int surfaces;
    private final Contacts contacts;

    SlidingFriction(Contacts contacts) {
        this.contacts = contacts;
    }

    /** The skin of a particle along all surfaces with these normals. */
    Skin skin(int i, double[] state, Vector3... normals) {
        surfaces = 0;
        for (Vector3 normal : normals) {
            keepAlong(normal);
        }
        return skin(i, state);
    }

    private Skin skin(int i, double[] state) {
        Optional<Scales> scales = contacts.scalesOf(i);
        if (scales.isEmpty()) {
            return Skin.SMOOTH;
        }
        Vector3 axis = scales.get().axis(state);
        return scales.get().skin(axis.length(), along(axis));
    }

    /**
     * Whether the friction of some contact is not a known vector times its own normal force, so that the forces have to
     * be solved without friction first: for a particle on several surfaces, or one that starts from rest or may stop.
     */
    boolean isIndirect(Row[] rows, double[] state) {
        for (int r = 0; r < rows.length; r++) {
            Row row = rows[r];
            int i = row.first;
            if (isRough(row) && (r > 0 && rows[r - 1].isContactOf(row)
                    || r + 1 < rows.length && rows[r + 1].isContactOf(row)
                    || row.surface.friction().law() == Friction.Law.COULOMB
                            && (contacts.mayStop(i) || contacts.startsFromRest(i) || isAtRest(row, state)))) {
                return true;
            }
        }
        return false;
    }

    private static boolean isRough(Row row) {
        return row.kind == Kind.SURFACE && row.surface.friction().law() != Friction.Law.NONE;
    }

    /** Whether a particle on a surface does not move along it. */
    private boolean isAtRest(Row row, double[] state) {
        slideOn(row);
        return along(state, Particles.STRIDE * row.first + 3).isZero();
    }

    /** Lets the particle slide along one surface. */
    private void slideOn(Row row) {
        axes[0] = Vector3.at(row.gradient, 0);
        surfaces = 1;
    }

    /**
     * Adds the friction of a contact to {@link Row#pull}, once for each evaluation of the rows: along all surfaces
     * that push its particle.
     *
     * @param pushKnown whether {@link Row#push} holds the normal forces without friction
     * @param force     the force that will move the particle, without friction (N), from entry 6 i + 3 on
     */
    void add(Row[] rows, Row row, boolean pushKnown, double[] force, double[] state) {
        if (!isRough(row)) {
            return;
        }
        slideOn(row);
        double all = 0;                                 // the particle's Coulomb friction
        for (int r = 0; pushKnown && r < rows.length; r++) {
            Row other = rows[r];
            if (other.isContactOf(row)) {
                all += other.surface.friction().ofCoulomb(other.push);
                if (other != row && other.push != 0) {
                    keepAlong(Vector3.at(other.gradient, 0));
                }
            }
        }
        Friction law = row.surface.friction();
        double push = pushKnown && row.push > 0 ? row.push : 1;
        double share = all > 0 ? law.ofCoulomb(row.push) / all : 1;
        Vector3 friction = find(law, skin(row.first, state), push, share, force, state,
                Particles.STRIDE * row.first + 3);
        Vector3.at(row.pull, 0).minus(friction).put(row.pull, 0);
    }

    /**
     * Adds the contact force of a particle that touches one surface only and slides there: what a {@link Block} has for
     * it, bit for bit, without a system of equations.
     *
     * @param signed whether the surface can only push
     * @param force  the forces of all effects (N), to which it is added
     * @return the power of friction (W)
     */
    double addAlone(int i, double mass, ContactSurface surface, boolean signed, double[] state, double[] force) {
        int v = Particles.STRIDE * i + 3;
        Vector3 normal = surface.normal(state, i);
        double all = push(normal, i, mass, surface, state, force);
        double push = signed ? Math.max(0, all) : all;
        Friction law = surface.friction();
        axes[0] = normal;
        surfaces = 1;
        if (law.law() == Friction.Law.NONE) {
            Vector3.at(force, v).plus(normal.times(push)).put(force, v);
            return 0;
        }
        boolean isIndirect = law.law() == Friction.Law.COULOMB && (contacts.mayStop(i)
                || contacts.startsFromRest(i) || along(state, v).isZero());
        Vector3 before = Vector3.at(force, v);
        if (isIndirect) {                               // against the force that moves it
            before.plus(normal.times(push)).put(force, v);
        }
        Vector3 friction = find(law, skin(i, state), isIndirect && push > 0 ? push : 1, 1, force, state, v);
        Vector3 pull = normal.minus(friction);
        before.plus(pull.times(push)).put(force, v);
        Vector3 velocity = Vector3.at(state, v);
        return push * (pull.dot(velocity) - normal.dot(velocity));
    }

    /**
     * The force that keeps a particle on a surface (N), negative if it would have to pull.
     *
     * @param normal the surface's normal at the particle
     * @param force  the total of all other forces (N)
     */
    static double push(Vector3 normal, int i, double mass, ContactSurface surface, double[] state, double[] force) {
        int v = Particles.STRIDE * i + 3;
        double bend = 0;
        if (!surface.obstacle().isFlat()) {
            double rate = normal.x() * state[v] + normal.y() * state[v + 1] + normal.z() * state[v + 2];
            bend = surface.obstacle().curvature(state, v - 3) * (Row.dot(state, v, state, v) - rate * rate) * mass;
        }
        return -(normal.x() * force[v] + normal.y() * force[v + 1] + normal.z() * force[v + 2] + bend);
    }

    /** Lets the particle slide only along one more surface, with this normal. */
    private void keepAlong(Vector3 normal) {
        Vector3 rest = along(normal);
        double length = length(rest);
        if (length > Tolerances.PARALLEL) {
            axes[surfaces] = surfaces == 0 ? normal : rest.over(length);
            surfaces++;
        }
    }

    /**
     * Finds the friction per 1 N of the normal force, with the opposite sign. It acts against a direction: a tangential
     * velocity (m/s), or the force that will move the particle (N). A particle that may stop within the step gets the
     * constant force that stops it at the end of the step, minus (F_t + m v_0/deltaT), or where that is more than mu N,
     * as much of it as mu N. This does not depend on the present velocity, whose direction turns the faster the slower
     * it is, so that any solver can follow it. The error is O(deltaT), as that of the time of the stop.
     *
     * @param skin  stretches the velocity and the friction
     * @param push  the normal force (N)
     * @param share the part of the particle's Coulomb friction that this surface can give: 1 if it is the only one
     * @param force the force that would move the particle along the surface, without friction (N), from entry v on
     * @param v     the index of the particle's velocity in the state
     */
    private Vector3 find(Friction law, Skin skin, double push, double share, double[] force, double[] state, int v) {
        double most = push * law.coefficient();
        if (law.law() == Friction.Law.SLIDE) {
            return skin.stretch(along(state, v)).times(most / push);
        }
        int i = v / Particles.STRIDE;
        boolean stops = contacts.mayStop(i);
        if (!stops && !contacts.startsFromRest(i)) {     // then the velocity is mostly round-off at first
            Vector3 direction = skin.stretch(followBeginning(along(state, v), i));
            double speed = length(direction);
            if (speed > 0) {
                return skin.stretch(direction.times(most / speed / push));
            }
        }
        Vector3 needed = along(force, v);
        if (stops) {
            needed = needed.plus(along(contacts.beginning(i)).times(contacts.stoppingRate(i)));
        }
        if (skin != Skin.SMOOTH) {
            return skin.balance(needed.times(share), most).over(push);
        }
        double size = length(needed);                   // if it is about to move: against the force that will move it
        return needed.times((share * size <= most ? share : most / size) / push);
    }

    /**
     * Compares the tangential velocity with that at the beginning of the step. A velocity that points back is mirrored:
     * straight back this gives the initial direction, as if the sliding had not reversed; obliquely it keeps friction
     * continuous, so that implicit solvers converge. A velocity that is only round-off is replaced by the initial one.
     */
    private Vector3 followBeginning(Vector3 velocity, int i) {
        Vector3 beginning = along(contacts.beginning(i));
        double length = length(beginning);
        if (length(velocity) < Tolerances.NO_DIRECTION * length) {
            return beginning;
        }
        double forward = velocity.dot(beginning);
        return forward < 0 ? velocity.minus(beginning.over(length).times(2 * forward / length)) : velocity;
    }

    /** The part along all surfaces of a vector that begins at an entry. */
    private Vector3 along(double[] vectors, int place) {
        return along(Vector3.at(vectors, place));
    }

    private Vector3 along(Vector3 vector) {
        double x = vector.x();
        double y = vector.y();
        double z = vector.z();
        double rounding = Tolerances.ALONG * vector.norm1();
        for (int a = 0; a < surfaces; a++) {            // without a new vector for each axis
            Vector3 axis = axes[a];
            double across = axis.x() * x + axis.y() * y + axis.z() * z;
            x -= across * axis.x();
            y -= across * axis.y();
            z -= across * axis.z();
        }
        boolean isNone = surfaces == 3 || Math.abs(x) + Math.abs(y) + Math.abs(z) <= rounding;
        return new Vector3(isNone ? 0 : x, isNone ? 0 : y, isNone ? 0 : z);
    }

    private static double length(Vector3 vector) {
        return Math.sqrt(vector.dot(vector));
    }
}
