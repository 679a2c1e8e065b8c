package particles.reactions;

import java.util.Arrays;
import java.util.Optional;
import particles.law.Particles;
import particles.law.Vector3;
import particles.reactions.ContactSurface.Bounce;

/**
 * A constraint row C(x) of a rod, of two balls in contact, of a wire or of a contact with a surface. At a state it has
 * its value C, its rate C' = J v, its bend J' v (the second derivative of C along the velocity), and its gradients,
 * which make up J. It involves one particle or two.
 *
 * <p>For a rod C = (|d|&sup2; - l&sup2;) / (2 l) with d = x_to - x_from: like |d| - l to first order, and smooth at d =
 * 0. Two balls that touch have the row of a rod between their centres, but it may only push. For a contact with a
 * surface, C is the distance, and its gradient is the normal N.
 */
final class Row {
    /** What a row belongs to. */
    enum Kind { ROD, BALLS, WIRE, SURFACE }

    private static final int STRIDE = Particles.STRIDE;
    private static final int NONE = -1;

    final Kind kind;
    final double length;                                // of a rod; errors are relative to it (m)
    int first;                                          // particle
    int second;                                         // particle, or NONE
    int number;                                         // of its surface, or in the list from which it was copied
    ContactSurface surface;
    Bounce bounce;                                      // of a contact
    boolean meets;                                      // whether a contact's particles approach each other
    boolean hasMet;                                     // whether they have at this moment, however they move now
    boolean latched;                                    // whether no rule ends it in this step; of balls
    boolean stops;                                      // whether they do not separate from it; of a contact
    boolean bounced;                                    // whether it did so in the last impact; of balls
    private Curve.Surface wire;                         // one of the two that meet in its wire
    double value;
    double rate;
    double bend;
    final double[] gradient = new double[6];            // for the first and second particle
    final double[] pull = new double[6];                // the force on both per 1 N; with friction once that is added
    final int[] movable = {NONE, NONE};                 // its particles, NONE for those that do not move
    double right;                                       // its entry of b
    double push;                                        // of a contact without friction (N)
    double force;                                       // in the last solution (N)
    double separation;                                  // acceleration (m/s^2), force (N), or speed after an impact

    /** The row of a rod or of two balls that keeps a length (m). */
    Row(Kind kind, int first, int second, double length) {
        this.kind = kind;
        this.first = first;
        this.second = second;
        this.length = length;
    }

    /** A row of a bead. */
    static Row wire(int particle, Curve.Surface wire) {
        Row row = new Row(Kind.WIRE, particle, NONE, 1);
        row.wire = wire;
        return row;
    }

    /** The row of a particle and the surface with an index, whether it touches or not. */
    static Row contact(int particle, int number, ContactSurface surface) {
        Row row = new Row(Kind.SURFACE, particle, NONE, 1);
        row.number = number;
        row.surface = surface;
        row.bounce = surface.bounce();
        return row;
    }

    /** The row of a kind with a number and a first particle. */
    static Optional<Row> find(Row[] rows, Kind kind, int number, int particle) {
        return Arrays.stream(rows).filter(row -> row.kind == kind && row.number == number && row.first == particle)
                .findFirst();
    }

    /** A copy without values, with its index in the list of rods, balls and wires. */
    Row numbered(int index) {
        Row row = new Row(kind, first, second, length);
        row.bounce = bounce;
        row.wire = wire;
        row.number = index;
        return row;
    }

    /** Evaluates the row, without friction yet. */
    void evaluate(double[] state) {
        int x = STRIDE * first;
        if (second >= 0) {
            evaluateLink(state, x, STRIDE * second);
        } else if (kind == Kind.WIRE) {
            Vector3 at = Vector3.at(state, x);
            value = wire.value(at);
            bend = wire.bend(at, Vector3.at(state, x + 3));
            wire.gradient(at).put(gradient, 0);
            rate = dot(gradient, 0, state, x + 3);
        } else {
            surface.normal(state, first).put(gradient, 0);
            rate = dot(gradient, 0, state, x + 3);
            value = surface.distance(state, first);
            if (!surface.obstacle().isFlat()) {
                bend = surface.obstacle().curvature(state, x)
                        * (dot(state, x + 3, state, x + 3) - rate * rate);
            }
        }
        System.arraycopy(gradient, 0, pull, 0, gradient.length);
    }

    private void evaluateLink(double[] state, int a, int b) {
        Vector3 d = Vector3.at(state, b).minus(Vector3.at(state, a));
        Vector3 u = Vector3.at(state, b + 3).minus(Vector3.at(state, a + 3));
        value = (d.dot(d) - length * length) / (2 * length);
        rate = d.dot(u) / length;
        bend = u.dot(u) / length;
        Vector3 along = d.over(length);
        along.times(-1).put(gradient, 0);
        along.put(gradient, 3);
    }

    static double dot(double[] a, int i, double[] b, int j) {
        return a[i] * b[j] + a[i + 1] * b[j + 1] + a[i + 2] * b[j + 2];
    }

    /** Its first or second particle. */
    int particle(int k) {
        return k == 0 ? first : second;
    }

    /** The distance of its ends (m). */
    double distance(double[] state) {
        return Vector3.at(state, STRIDE * second).minus(Vector3.at(state, STRIDE * first)).length();
    }

    /** Whether it may only push. */
    boolean isContact() {
        return kind == Kind.SURFACE || kind == Kind.BALLS;
    }

    /** Whether it is a contact of the same particle as another row. */
    boolean isContactOf(Row other) {
        return kind == Kind.SURFACE && first == other.first;
    }

    /** Whether none of its particles can move, so that it is left out. */
    boolean isIdle() {
        return movable[0] < 0 && movable[1] < 0;
    }

    /** Whether it moves a particle. */
    boolean moves(int i) {
        return movable[0] == i || movable[1] == i;
    }

    /** The relative velocity of a contact across its normal: of its second particle, or of its only one. */
    Vector3 slip(double[] state) {
        Vector3 velocity = Vector3.at(state, STRIDE * first + 3);
        Vector3 normal = Vector3.at(gradient, 0);
        if (second >= 0) {
            velocity = Vector3.at(state, STRIDE * second + 3).minus(Vector3.at(state, STRIDE * first + 3));
            normal = Vector3.at(gradient, 3).normalized();
        }
        return velocity.minus(normal.times(normal.dot(velocity)));
    }

    /** Its gradients times a vector of each particle, which begins at {@code place} + 6 i. */
    double times(double[] vectors, int place) {
        return dot(gradient, 0, vectors, STRIDE * first + place)
                + (second < 0 ? 0 : dot(gradient, 3, vectors, STRIDE * second + place));
    }

    /** Adds its force to the forces on its particles, with friction. */
    void addForce(double[] forces) {
        for (int k = 0; k < (second < 0 ? 1 : 2); k++) {
            int f = STRIDE * particle(k) + 3;
            Vector3.at(forces, f).plus(Vector3.at(pull, 3 * k).times(force)).put(forces, f);
        }
    }

    /** The acceleration of its lighter particle by its force alone (m/s&sup2;). */
    double largestAcceleration(double[] inverseMasses) {
        return Math.abs(force) * Math.max(inverseMasses[first], second < 0 ? 0 : inverseMasses[second]);
    }

    /** The power of the friction that goes with its force (W); surfaces at rest do no other work. */
    double frictionPower(double[] state) {
        return kind == Kind.SURFACE ? force * (dot(pull, 0, state, STRIDE * first + 3) - rate) : 0;
    }

    /** The contribution of moving anchors to the rate: gradients times the anchors' velocities. */
    double rateOfAnchors(double[] state, double[] inverseMasses) {
        double sum = 0;
        for (int k = 0; k < (second < 0 ? 1 : 2); k++) {
            int i = particle(k);
            sum += inverseMasses[i] == 0 ? dot(gradient, 3 * k, state, STRIDE * i + 3) : 0;
        }
        return sum;
    }

    /**
     * Whether the anchor of a rod pulls or pushes its other end, at rest, along the rod; then nothing can hold that
     * end.
     *
     * @param accelerations the accelerations of moving anchors (m/s&sup2;), in the entries of their velocities
     */
    boolean isDraggedByAnchor(double[] state, double[] accelerations, double[] inverseMasses) {
        if (second < 0 || inverseMasses[first] != 0 && inverseMasses[second] != 0) {
            return false;
        }
        evaluate(state);
        int k = inverseMasses[first] == 0 ? 0 : 1;
        int v = STRIDE * particle(k) + 3;
        double turn = dot(state, v, state, v) / length;
        double along = turn + dot(gradient, 3 * k, accelerations, v);
        double most = turn + Vector3.at(accelerations, v).norm1();
        return Math.abs(rateOfAnchors(state, inverseMasses)) > Tolerances.STANDSTILL
                || Math.abs(along) > Tolerances.STANDSTILL * (1 + most);
    }
}
