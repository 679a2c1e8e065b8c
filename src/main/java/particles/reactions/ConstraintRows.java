package particles.reactions;

import java.util.ArrayList;
import java.util.List;
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

    /** A rod, or two balls in contact. */
    private record Rod(int from, int to, double length) {
    }

    /** A particle on a wire. */
    private record Bead(int particle, Curve wire) {
    }

    private final List<Rod> rods = new ArrayList<>();
    private final List<Rod> contacts = new ArrayList<>();
    private final List<Bead> beads = new ArrayList<>();

    double[] value = {};                                // by row: rods, then contacts, then two for each bead
    double[] rate = {};
    double[] bend = {};
    double[] gradient = {};                             // 6 a row: for the first and second particle
    private final double[] values = new double[Curve.ROWS];
    private final double[] gradients = new double[3 * Curve.ROWS];
    private final double[] bends = new double[Curve.ROWS];

    void addRod(int from, int to, double length) {
        rods.add(new Rod(from, to, length));
        fit();
    }

    /** Adds a contact of two balls, which are this far apart (m), after all rods and contacts. */
    void addContact(int from, int to, double distance) {
        contacts.add(new Rod(from, to, distance));
        fit();
    }

    void removeContact(int row) {
        contacts.remove(row - rods.size());
        fit();
    }

    void addBead(int particle, Curve along) {
        beads.add(new Bead(particle, along));
        fit();
    }

    /** Whether a row is that of two balls in contact. */
    boolean isContact(int row) {
        return row >= rods.size() && row < getBeadRows();
    }

    /** The index after the last rod or contact. */
    int getBeadRows() {
        return rods.size() + contacts.size();
    }

    private Rod rod(int row) {
        return row < rods.size() ? rods.get(row) : contacts.get(row - rods.size());
    }

    private void fit() {
        value = new double[count()];
        rate = new double[count()];
        bend = new double[count()];
        gradient = new double[6 * count()];
    }

    /** Updates indices after particles were removed; their rods, contacts and beads are removed too. */
    void reindex(int[] newIndex) {
        for (List<Rod> joined : List.of(rods, contacts)) {
            joined.replaceAll(rod -> new Rod(newIndex[rod.from], newIndex[rod.to], rod.length));
            joined.removeIf(rod -> rod.from < 0 || rod.to < 0);
        }
        beads.replaceAll(bead -> new Bead(newIndex[bead.particle], bead.wire));
        beads.removeIf(bead -> bead.particle < 0);
        fit();
    }

    int count() {
        return getBeadRows() + Curve.ROWS * beads.size();
    }

    int getRods() {
        return rods.size();
    }

    int getBeads() {
        return beads.size();
    }

    /** The particle of a row's first three gradient entries. */
    int first(int row) {
        return row < getBeadRows() ? rod(row).from : beads.get((row - getBeadRows()) / Curve.ROWS).particle;
    }

    /** The particle of its other three, or -1 if the row involves only one. */
    int second(int row) {
        return row < getBeadRows() ? rod(row).to : -1;
    }

    /** The length to which errors of a row are relative (m): a rod's length, and 1 m for a wire. */
    double scale(int row) {
        return row < getBeadRows() ? length(row) : 1;
    }

    double length(int rod) {
        return rod(rod).length;
    }

    /** The distance of a rod's ends (m). */
    double distance(int rod, double[] state) {
        return apart(rod, state, 0).length();
    }

    private Vector3 apart(int rod, double[] state, int place) {
        return Vector3.at(state, STRIDE * second(rod) + place).minus(Vector3.at(state, STRIDE * first(rod) + place));
    }

    void evaluate(double[] state) {
        for (int r = 0; r < getBeadRows(); r++) {
            evaluateRod(r, state);
        }
        int row = getBeadRows();
        for (Bead bead : beads) {
            int x = STRIDE * bead.particle;
            bead.wire.evaluate(state, x, values, gradients, bends);
            for (int k = 0; k < Curve.ROWS; k++, row++) {
                value[row] = values[k];
                bend[row] = bends[k];
                System.arraycopy(gradients, 3 * k, gradient, 6 * row, 3);
                rate[row] = dot(6 * row, state, x + 3);
            }
        }
    }

    private void evaluateRod(int r, double[] state) {
        Vector3 d = apart(r, state, 0);
        Vector3 v = apart(r, state, 3);
        double l = length(r);
        value[r] = (d.dot(d) - l * l) / (2 * l);
        rate[r] = d.dot(v) / l;
        bend[r] = v.dot(v) / l;
        d.put(gradient, 6 * r + 3);
        for (int g = 6 * r; g < 6 * r + 3; g++) {
            gradient[g + 3] /= l;
            gradient[g] = -gradient[g + 3];
        }
    }

    private double dot(int g, double[] vectors, int i) {
        return gradient[g] * vectors[i] + gradient[g + 1] * vectors[i + 1] + gradient[g + 2] * vectors[i + 2];
    }

    /** A row's gradients times a vector of each particle, which begins at {@code place} + 6 i. */
    double times(int row, double[] vectors, int place) {
        return dot(6 * row, vectors, STRIDE * first(row) + place)
                + (row < getBeadRows() ? dot(6 * row + 3, vectors, STRIDE * second(row) + place) : 0);
    }

    /** The contribution of moving anchors to the rate of a row: gradients times the anchors' velocities. */
    double rateOfAnchors(int row, double[] state, double[] inverseMasses) {
        double sum = 0;
        for (int k = 0; k < 2; k++) {
            int i = k == 0 ? first(row) : second(row);
            sum += i >= 0 && inverseMasses[i] == 0 ? dot(6 * row + 3 * k, state, STRIDE * i + 3) : 0;
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
        boolean isFirst = inverseMasses[first(row)] == 0;
        if (row >= getBeadRows() || !isFirst && inverseMasses[second(row)] != 0) {
            return false;
        }
        int g = 6 * row + (isFirst ? 0 : 3);
        int v = STRIDE * (isFirst ? first(row) : second(row)) + 3;
        Vector3 velocity = Vector3.at(state, v);
        double bend = velocity.dot(velocity) / length(row);
        double along = bend + dot(g, accelerations, v);
        double most = bend + Vector3.at(accelerations, v).norm1();
        return Math.abs(rateOfAnchors(row, state, inverseMasses)) > RestingContacts.ROUNDING
                || Math.abs(along) > RestingContacts.ROUNDING * (1 + most);
    }

    /** Adds a row's force on its particles, lambda times the gradients. */
    void addForce(int row, double lambda, double[] force) {
        addTo(force, STRIDE * first(row) + 3, lambda, 6 * row);
        if (row < getBeadRows()) {
            addTo(force, STRIDE * second(row) + 3, lambda, 6 * row + 3);
        }
    }

    private void addTo(double[] vectors, int i, double amount, int g) {
        vectors[i] += amount * gradient[g];
        vectors[i + 1] += amount * gradient[g + 1];
        vectors[i + 2] += amount * gradient[g + 2];
    }
}
