package particles.reactions;

import java.util.Arrays;
import particles.law.Particles;
import particles.law.Vector3;
import particles.reactions.wires.Curve;

/**
 * The rows C_r(x) = 0 of rods, wires and balls in contact at one state, in flat arrays: values C, rates C' = J v, bends
 * J' v (the second derivative of C along the velocity), and the gradients that make up J. A row involves one particle
 * or two.
 *
 * <p>For a rod C = (|d|&sup2; - l&sup2;) / (2 l) with d = x_to - x_from: like |d| - l to first order, and smooth at d =
 * 0. Two balls that touch have the row of a rod between their centres, but it may only push.
 */
final class ConstraintRows {
    private static final int STRIDE = Particles.STRIDE;

    private int rods;                                   // and after them the contacts of balls
    private int contacts;
    private int beads;
    private int[] from = new int[4];                    // by rod
    private int[] to = new int[4];
    private double[] length = new double[4];
    private int[] bead = new int[4];                    // by bead: its particle
    private Curve[] curve = new Curve[4];

    double[] value = {};                                // by row: rods first, then two for each bead
    double[] rate = {};
    double[] bend = {};
    double[] gradient = {};                             // 6 a row: for the first and second particle
    private final double[] values = new double[Curve.ROWS];
    private final double[] gradients = new double[3 * Curve.ROWS];
    private final double[] bends = new double[Curve.ROWS];

    void addRod(int from, int to, double length) {
        if (rods == this.from.length) {
            this.from = Arrays.copyOf(this.from, 2 * rods);
            this.to = Arrays.copyOf(this.to, 2 * rods);
            this.length = Arrays.copyOf(this.length, 2 * rods);
        }
        this.from[rods] = from;
        this.to[rods] = to;
        this.length[rods++] = length;
        fit();
    }

    /** Adds a contact of two balls, which are this far apart (m), after all rods and contacts. */
    void addContact(int from, int to, double distance) {
        addRod(from, to, distance);
        contacts++;
    }

    void removeContact(int row) {
        int later = --rods - row;
        contacts--;
        System.arraycopy(from, row + 1, from, row, later);
        System.arraycopy(to, row + 1, to, row, later);
        System.arraycopy(length, row + 1, length, row, later);
        fit();
    }

    /** Whether a row is that of two balls in contact. */
    boolean isContact(int row) {
        return row >= getRods() && row < rods;
    }

    /** The index after the last rod or contact. */
    int getBeadRows() {
        return rods;
    }

    void addBead(int particle, Curve along) {
        if (beads == bead.length) {
            bead = Arrays.copyOf(bead, 2 * beads);
            curve = Arrays.copyOf(curve, 2 * beads);
        }
        bead[beads] = particle;
        curve[beads++] = along;
        fit();
    }

    private void fit() {
        value = new double[count()];
        rate = new double[count()];
        bend = new double[count()];
        gradient = new double[6 * count()];
    }

    /** Updates indices after particles were removed; their rods, contacts and beads are removed too. */
    void reindex(int[] newIndex) {
        int kept = 0;
        int begin = getRods();
        contacts = 0;
        for (int r = 0; r < rods; r++) {
            if (newIndex[from[r]] >= 0 && newIndex[to[r]] >= 0) {
                from[kept] = newIndex[from[r]];
                to[kept] = newIndex[to[r]];
                length[kept++] = length[r];
                contacts += r < begin ? 0 : 1;
            }
        }
        rods = kept;
        kept = 0;
        for (int b = 0; b < beads; b++) {
            if (newIndex[bead[b]] >= 0) {
                bead[kept] = newIndex[bead[b]];
                curve[kept++] = curve[b];
            }
        }
        beads = kept;
        fit();
    }

    int count() {
        return rods + Curve.ROWS * beads;
    }

    int getRods() {
        return rods - contacts;
    }

    int getBeads() {
        return beads;
    }

    /** The particle of a row's first three gradient entries. */
    int first(int row) {
        return row < rods ? from[row] : bead[(row - rods) / Curve.ROWS];
    }

    /** The particle of its other three, or -1 if the row involves only one. */
    int second(int row) {
        return row < rods ? to[row] : -1;
    }

    /** The length to which errors of a row are relative (m): a rod's length, and 1 m for a wire. */
    double scale(int row) {
        return row < rods ? length[row] : 1;
    }

    double length(int rod) {
        return length[rod];
    }

    /** The distance of a rod's ends (m). */
    double distance(int rod, double[] state) {
        return Vector3.at(state, STRIDE * to[rod]).minus(Vector3.at(state, STRIDE * from[rod])).length();
    }

    void evaluate(double[] state) {
        for (int r = 0; r < rods; r++) {
            evaluateRod(r, state, STRIDE * from[r], STRIDE * to[r]);
        }
        for (int b = 0, row = rods; b < beads; b++, row += Curve.ROWS) {
            int x = STRIDE * bead[b];
            curve[b].evaluate(state, x, values, gradients, bends);
            for (int k = 0; k < Curve.ROWS; k++) {
                value[row + k] = values[k];
                bend[row + k] = bends[k];
                System.arraycopy(gradients, 3 * k, gradient, 6 * (row + k), 3);
                rate[row + k] = dot(6 * (row + k), state, x + 3);
            }
        }
    }

    private void evaluateRod(int r, double[] state, int a, int b) {
        double dx = state[b] - state[a];
        double dy = state[b + 1] - state[a + 1];
        double dz = state[b + 2] - state[a + 2];
        double u = state[b + 3] - state[a + 3];
        double v = state[b + 4] - state[a + 4];
        double w = state[b + 5] - state[a + 5];
        double l = length[r];
        value[r] = (dx * dx + dy * dy + dz * dz - l * l) / (2 * l);
        rate[r] = (dx * u + dy * v + dz * w) / l;
        bend[r] = (u * u + v * v + w * w) / l;
        int g = 6 * r;
        gradient[g + 3] = dx / l;
        gradient[g + 4] = dy / l;
        gradient[g + 5] = dz / l;
        gradient[g] = -gradient[g + 3];
        gradient[g + 1] = -gradient[g + 4];
        gradient[g + 2] = -gradient[g + 5];
    }

    private double dot(int g, double[] vectors, int i) {
        return gradient[g] * vectors[i] + gradient[g + 1] * vectors[i + 1] + gradient[g + 2] * vectors[i + 2];
    }

    /** A row's gradients times a vector of each particle, which begins at {@code place} + 6 i. */
    double times(int row, double[] vectors, int place) {
        return dot(6 * row, vectors, STRIDE * first(row) + place)
                + (row < rods ? dot(6 * row + 3, vectors, STRIDE * to[row] + place) : 0);
    }

    /** The contribution of moving anchors to the rate of a row: gradients times the anchors' velocities. */
    double rateOfAnchors(int row, double[] state, double[] inverseMasses) {
        double sum = 0;
        for (int k = 0; k < (row < rods ? 2 : 1); k++) {
            int i = k == 0 ? first(row) : second(row);
            sum += inverseMasses[i] == 0 ? dot(6 * row + 3 * k, state, STRIDE * i + 3) : 0;
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
        int end = row >= rods ? -1 : inverseMasses[from[row]] == 0 ? from[row] : inverseMasses[to[row]] == 0 ? to[row]
                : -1;
        if (end < 0) {
            return false;
        }
        int g = 6 * row + (end == from[row] ? 0 : 3);
        int v = STRIDE * end + 3;
        Vector3 velocity = Vector3.at(state, v);
        double bend = velocity.dot(velocity) / length[row];
        double along = bend + dot(g, accelerations, v);
        double most = bend + Vector3.at(accelerations, v).norm1();
        return Math.abs(rateOfAnchors(row, state, inverseMasses)) > RestingContacts.ROUNDING
                || Math.abs(along) > RestingContacts.ROUNDING * (1 + most);
    }

    /** Adds a row's force on its particles, lambda times the gradients. */
    void addForce(int row, double lambda, double[] force) {
        addTo(force, STRIDE * first(row) + 3, lambda, 6 * row);
        if (row < rods) {
            addTo(force, STRIDE * to[row] + 3, lambda, 6 * row + 3);
        }
    }

    private void addTo(double[] vectors, int i, double amount, int g) {
        vectors[i] += amount * gradient[g];
        vectors[i + 1] += amount * gradient[g + 1];
        vectors[i + 2] += amount * gradient[g + 2];
    }
}
