package particles.reactions;

import java.util.Arrays;
import java.util.function.IntPredicate;
import particles.law.Particles;
import particles.reactions.algebra.ActiveSetMethod;
import particles.reactions.contact.ContactModes;

/**
 * Dense linear system for the rods, wires and contacts of one linkage: rows of rods and wires first, then contacts.
 * Column c is the effect of a force of 1 N of row c on all rows. A sliding contact's force includes its friction, so
 * the matrix is not symmetric: A = J W (J - S)<sup>T</sup>. The time of a solution is proportional to the cube of the
 * number of rows: a few milliseconds for a hundred.
 */
final class JointSystem {
    private static final int STRIDE = Particles.STRIDE;

    private final ConstraintRows rows;
    private final Particles particles;
    private final RestingContacts contacts;
    private final ActiveSetMethod activeSet = new ActiveSetMethod();
    final ContactRows touching;
    double[] mobility = {};                             // 1/m, 0 for particles that do not move
    double[] right = {};
    double[] solution = {};
    private int[] members = {};
    private int[] who = {};                             // two particles a row, -1 for none
    private double[] gradient = {};                     // 6 doubles a row
    private double[] pull = {};                         // the force on both particles per 1 N of a row
    private double[] matrix = {};
    private boolean sticking;

    JointSystem(ConstraintRows rows, Particles particles, RestingContacts contacts) {
        this.rows = rows;
        this.particles = particles;
        this.contacts = contacts;
        touching = new ContactRows(contacts);
    }

    /**
     * Builds the rows of a linkage.
     *
     * @return whether any of its particles touches anything
     */
    boolean take(Linkage linkage, double[] state) {
        return take(linkage, state, contacts.getModes()::isSticking);
    }

    /**
     * Builds the rows of a linkage.
     *
     * @param held which particles are treated as sticking
     * @return whether any of its particles touches anything
     */
    boolean take(Linkage linkage, double[] state, IntPredicate held) {
        begin();
        members = linkage.members();
        touching.clear();
        sticking = false;
        for (int i : linkage.particles()) {
            if (held.test(i)) {
                mobility[i] = 0;
                sticking = true;
            } else {
                touching.addTouching(i, state);
            }
        }
        return sticking || touching.count > 0;
    }

    /** Builds the rows of a linkage for an impact: no particle sticks, and the impact's contact has a row. */
    void takeForImpact(Linkage linkage, double[] state, int surface, int particle) {
        begin();
        members = linkage.members();
        touching.clear();
        touching.add(surface, particle, state);
        for (int i : linkage.particles()) {
            for (int p = 0; p < contacts.getSurfaces().size(); p++) {
                if (contacts.getModes().get(p, i) != ContactModes.Mode.FREE && !(p == surface && i == particle)) {
                    touching.add(p, i, state);
                }
            }
        }
    }

    boolean isAnySticking() {
        return sticking;
    }

    private void begin() {
        int n = particles.count();
        if (mobility.length < n) {
            mobility = new double[n];
        }
        System.arraycopy(particles.getInverseMasses(), 0, mobility, 0, n);
    }

    int constraintRows() {
        return members.length;
    }

    int size() {
        return members.length + touching.count;
    }

    int member(int r) {
        return members[r];
    }

    /** Assembles the matrix and clears the right-hand side. */
    void assemble() {
        int n = size();
        if (who.length < 2 * n) {
            who = new int[2 * n];
            gradient = new double[6 * n];
            pull = new double[6 * n];
            matrix = new double[n * n];
            right = new double[n];
            solution = new double[n];
        }
        for (int r = 0; r < members.length; r++) {
            who[2 * r] = rows.first(members[r]);
            who[2 * r + 1] = rows.second(members[r]);
            System.arraycopy(rows.gradient, 6 * members[r], gradient, 6 * r, 6);
            System.arraycopy(rows.gradient, 6 * members[r], pull, 6 * r, 6);
        }
        for (int k = 0, r = members.length; k < touching.count; k++, r++) {
            who[2 * r] = touching.particle[k];
            who[2 * r + 1] = -1;
            for (int c = 0; c < 3; c++) {
                gradient[6 * r + c] = touching.normal[3 * k + c];
                pull[6 * r + c] = touching.normal[3 * k + c] - touching.slip[3 * k + c];
            }
        }
        Arrays.fill(right, 0, n, 0.0);
        for (int r = 0; r < n; r++) {
            for (int c = 0; c < n; c++) {
                matrix[r * n + c] = entry(r, c);
            }
        }
    }

    private double entry(int r, int c) {
        double sum = 0;
        for (int k = 0; k < 2; k++) {
            int i = who[2 * r + k];
            for (int l = 0; l < 2 && i >= 0 && mobility[i] != 0; l++) {
                if (i == who[2 * c + l]) {
                    int g = 6 * r + 3 * k;
                    int p = 6 * c + 3 * l;
                    sum += mobility[i] * (gradient[g] * pull[p] + gradient[g + 1] * pull[p + 1]
                            + gradient[g + 2] * pull[p + 2]);
                }
            }
        }
        return sum;
    }

    /** Whether no particle of a row can move, so that it is left out. */
    boolean isIdle(int r) {
        return matrix[r * size() + r] == 0 && r < members.length;
    }

    /**
     * Solves for {@link #right}.
     *
     * @param signed as for {@link ActiveSetMethod#solve}
     * @param bound  the number of the first contacts that hold in any case
     */
    boolean solve(boolean signed, int bound) {
        return activeSet.solve(size(), members.length + bound, matrix, right, signed, solution);
    }

    /** The separating acceleration of contact k in the solution (m/s&sup2;), for contacts without a normal force. */
    double separation(int k) {
        int n = size();
        int r = members.length + k;
        double w = -right[r];
        for (int c = 0; c < n; c++) {
            w += matrix[r * n + c] * solution[c];
        }
        return w;
    }

    double left() {
        return activeSet.left();
    }

    /**
     * Moves the linkage's particles along the rows by the solution, without friction.
     *
     * @param place 0 to move positions, 3 to change velocities
     */
    void move(double[] state, int place) {
        for (int r = 0; r < size(); r++) {
            for (int k = 0; k < 2; k++) {
                int i = who[2 * r + k];
                for (int c = 0; c < 3 && i >= 0; c++) {
                    state[STRIDE * i + place + c] += mobility[i] * solution[r] * gradient[6 * r + 3 * k + c];
                }
            }
        }
    }
}
