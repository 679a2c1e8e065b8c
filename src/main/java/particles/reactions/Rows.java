package particles.reactions;

import java.util.Arrays;
import particles.law.Particles;
import particles.law.Vector3;
import particles.reactions.contact.ContactSurface;
import particles.reactions.contact.Friction;
import particles.reactions.wires.Curve;

/**
 * Constraint rows C_r(x) in flat arrays: rods, balls in contact, wires and contacts with surfaces fill them, all else
 * reads them. At a state, a row has its value C, its rate C' = J v, its bend J' v (the second derivative of C along the
 * velocity), and its gradients, which make up J. It involves one particle or two.
 *
 * <p>For a rod C = (|d|&sup2; - l&sup2;) / (2 l) with d = x_to - x_from: like |d| - l to first order, and smooth at d =
 * 0. Two balls that touch have the row of a rod between their centres, but it may only push. For a contact with a
 * surface, C is the distance, and its gradient is the normal N.
 */
final class Rows {
    /** What a row belongs to. */
    enum Kind { ROD, BALLS, WIRE, SURFACE }

    private static final int STRIDE = Particles.STRIDE;

    int count;
    Kind[] kind = {};
    int[] first = {};                                   // particle
    int[] second = {};                                  // particle, or -1 for none
    int[] number = {};                                  // of its surface, or in the list from which it was copied
    double[] length = {};                               // of a rod; errors are relative to it (m)
    private Curve[] curve = {};
    private int[] function = {};                        // which of its curve's
    private ContactSurface[] surface = {};
    double[] value = {};
    double[] rate = {};
    double[] bend = {};
    double[] gradient = {};                             // 6 a row: for the first and second particle
    double[] pull = {};                                 // the force on both per 1 N; with friction once that is added
    double[] push = {};                                 // of a contact without friction (N)
    private final int[] ofKind = new int[Kind.values().length];
    private int changes;

    void clear() {
        count = 0;
        Arrays.fill(ofKind, 0);
    }

    /** Counts changes of the list. */
    int getChanges() {
        return changes;
    }

    /** Adds the row of a rod or of two balls, in the order of kinds; it keeps this distance (m). */
    void addLink(Kind link, int from, int to, double distance) {
        int r = append(link, from, to, distance);
        for (; r > 0 && kind[r - 1].compareTo(link) > 0; r--) {
            copy(this, r - 1, r);
        }
        set(r, link, from, to, distance);
    }

    /** Adds the rows of a bead. */
    void addBead(int particle, Curve wire) {
        for (int k = 0; k < Curve.ROWS; k++) {
            int r = append(Kind.WIRE, particle, -1, 1);
            curve[r] = wire;
            function[r] = k;
        }
    }

    /** Adds the row of a particle and the surface with an index, whether it touches or not. */
    void addContact(int particle, int index, ContactSurface on) {
        int r = append(Kind.SURFACE, particle, -1, 1);
        number[r] = index;
        surface[r] = on;
        bend[r] = 0;
    }

    /** Adds a row of another list. */
    void add(Rows from, int row) {
        int r = append(from.kind[row], from.first[row], from.second[row], from.length[row]);
        copy(from, row, r);
        number[r] = row;
    }

    private void set(int r, Kind kind, int first, int second, double length) {
        this.kind[r] = kind;
        this.first[r] = first;
        this.second[r] = second;
        this.length[r] = length;
    }

    private int append(Kind more, int from, int to, double distance) {
        ofKind[more.ordinal()]++;
        if (count == kind.length) {
            int size = 2 * count + 1;
            kind = Arrays.copyOf(kind, size);
            first = Arrays.copyOf(first, size);
            second = Arrays.copyOf(second, size);
            number = Arrays.copyOf(number, size);
            length = Arrays.copyOf(length, size);
            curve = Arrays.copyOf(curve, size);
            function = Arrays.copyOf(function, size);
            surface = Arrays.copyOf(surface, size);
            value = new double[size];
            rate = new double[size];
            bend = new double[size];
            gradient = new double[6 * size];
            pull = new double[6 * size];
            push = new double[size];
        }
        changes++;
        set(count, more, from, to, distance);
        return count++;
    }

    private void copy(Rows from, int row, int r) {
        set(r, from.kind[row], from.first[row], from.second[row], from.length[row]);
        curve[r] = from.curve[row];
        function[r] = from.function[row];
    }

    /** Removes a row. */
    void remove(int row) {
        changes++;
        ofKind[kind[row].ordinal()]--;
        count--;
        for (int r = row; r < count; r++) {
            copy(this, r + 1, r);
        }
    }

    /** Updates indices after particles were removed; their rows are removed too. */
    void reindex(int[] newIndex) {
        changes++;
        for (int r = count - 1; r >= 0; r--) {
            first[r] = newIndex[first[r]];
            second[r] = second[r] < 0 ? -1 : newIndex[second[r]];
            if (first[r] < 0 || second[r] < 0 && kind[r] != Kind.WIRE) {
                remove(r);
            }
        }
    }

    /** The index of the first row of a kind, or of a later one; rows must be in the order of kinds. */
    int begin(Kind from) {
        int r = 0;
        for (int k = 0; k < from.ordinal(); k++) {
            r += ofKind[k];
        }
        return r;
    }

    /** The distance of a rod's ends (m). */
    double distance(int rod, double[] state) {
        return Vector3.at(state, STRIDE * second[rod]).minus(Vector3.at(state, STRIDE * first[rod])).length();
    }

    /**
     * Evaluates all rows, without friction yet.
     *
     * @param withDistance whether the values of contacts with surfaces are needed
     */
    void evaluate(double[] state, boolean withDistance) {
        for (int r = 0; r < count; r++) {
            int x = STRIDE * first[r];
            if (kind[r] == Kind.SURFACE) {
                evaluateContact(r, state, x, withDistance);
            } else if (kind[r] == Kind.WIRE) {
                Vector3 at = Vector3.at(state, x);
                value[r] = curve[r].value(function[r], at);
                bend[r] = curve[r].bend(function[r], at, Vector3.at(state, x + 3));
                curve[r].gradient(function[r], at).put(gradient, 6 * r);
                rate[r] = dot(gradient, 6 * r, state, x + 3);
            } else {
                evaluateLink(r, state, x, STRIDE * second[r]);
            }
        }
        System.arraycopy(gradient, 0, pull, 0, 6 * count);
    }

    private void evaluateLink(int r, double[] state, int a, int b) {
        Vector3 d = Vector3.at(state, b).minus(Vector3.at(state, a));
        Vector3 u = Vector3.at(state, b + 3).minus(Vector3.at(state, a + 3));
        double l = length[r];
        value[r] = (d.dot(d) - l * l) / (2 * l);
        rate[r] = d.dot(u) / l;
        bend[r] = u.dot(u) / l;
        Vector3 along = d.over(l);
        along.times(-1).put(gradient, 6 * r);
        along.put(gradient, 6 * r + 3);
    }

    private void evaluateContact(int r, double[] state, int x, boolean withDistance) {
        ContactSurface on = surface[r];
        on.normal(state, first[r]).put(gradient, 6 * r);
        rate[r] = dot(gradient, 6 * r, state, x + 3);
        if (withDistance) {
            value[r] = on.distance(state, first[r]);
        }
        if (!on.obstacle().isFlat()) {
            bend[r] = on.obstacle().curvature(state[x], state[x + 1], state[x + 2])
                    * (dot(state, x + 3, state, x + 3) - rate[r] * rate[r]);
        }
    }

    static double dot(double[] a, int i, double[] b, int j) {
        return a[i] * b[j] + a[i + 1] * b[j + 1] + a[i + 2] * b[j + 2];
    }

    /** A row's gradients times a vector of each particle, which begins at {@code place} + 6 i. */
    double times(int row, double[] vectors, int place) {
        return dot(gradient, 6 * row, vectors, STRIDE * first[row] + place) + (second[row] < 0 ? 0
                : dot(gradient, 6 * row + 3, vectors, STRIDE * second[row] + place));
    }

    /** Adds a row's force on its particles, with friction. */
    void addForce(int row, double lambda, double[] force) {
        for (int k = 0; k < (second[row] < 0 ? 1 : 2); k++) {
            int f = STRIDE * (k == 0 ? first : second)[row] + 3;
            Vector3.at(force, f).plus(Vector3.at(pull, 6 * row + 3 * k).times(lambda)).put(force, f);
        }
    }

    /** The power of friction per 1 N of a row that keeps its particle on a surface at rest (W/N). */
    double frictionPower(int row, double[] state) {
        return kind[row] == Kind.SURFACE ? dot(pull, 6 * row, state, STRIDE * first[row] + 3) - rate[row] : 0;
    }

    /** The contribution of moving anchors to the rate of a row: gradients times the anchors' velocities. */
    double rateOfAnchors(int row, double[] state, double[] inverseMasses) {
        double sum = 0;
        for (int k = 0; k < (second[row] < 0 ? 1 : 2); k++) {
            int i = (k == 0 ? first : second)[row];
            sum += inverseMasses[i] == 0 ? dot(gradient, 6 * row + 3 * k, state, STRIDE * i + 3) : 0;
        }
        return sum;
    }

    /**
     * Whether the anchor of a rod pulls or pushes its other end, at rest, along the rod; then nothing can hold that
     * end.
     *
     * @param accelerations the accelerations of moving anchors (m/s&sup2;), in the entries of their velocities
     */
    boolean isDraggedByAnchor(int row, double[] state, double[] accelerations, double[] inverseMasses) {
        if (second[row] < 0 || inverseMasses[first[row]] != 0 && inverseMasses[second[row]] != 0) {
            return false;
        }
        int k = inverseMasses[first[row]] == 0 ? 0 : 1;
        int v = STRIDE * (k == 0 ? first : second)[row] + 3;
        double bend = dot(state, v, state, v) / length[row];
        double along = bend + dot(gradient, 6 * row + 3 * k, accelerations, v);
        double most = bend + Vector3.at(accelerations, v).norm1();
        return Math.abs(rateOfAnchors(row, state, inverseMasses)) > RestingContacts.ROUNDING
                || Math.abs(along) > RestingContacts.ROUNDING * (1 + most);
    }

    /** The largest curvature of the surfaces (1/m), 0 for planes. */
    double curvature(double[] state) {
        double most = 0;
        for (int r = 0; r < count; r++) {
            most = Math.max(most, surface[r].curvature(state, first[r]));
        }
        return most;
    }

    Friction friction(int row) {
        return surface[row].friction();
    }
}
