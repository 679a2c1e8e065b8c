package particles.reactions;

import java.util.Arrays;
import java.util.BitSet;
import java.util.function.IntPredicate;
import particles.law.Particles;
import particles.reactions.algebra.ActiveSetMethod;
import particles.reactions.algebra.EnvelopeMatrix;
import particles.reactions.contact.ContactModes.Mode;

/**
 * A block: the particles connected by rods, wires and contacts of balls, or one particle without any, and the linear
 * system of their reaction forces. It has a row for each rod and each contact, and two for each particle on a wire. Two
 * balls in contact have the row of a rod that may only push. Column c of the matrix is the acceleration of all rows if
 * row c has a force of 1 N. The force of a sliding contact includes friction, -S<sup>T</sup> lambda, so the matrix A =
 * J W (J - S)<sup>T</sup> is not symmetric. It has entries only where two rows share a movable particle. A particle's
 * contacts come right after its first rod, so the envelope of a chain is narrow. A single particle on one surface has
 * the 1 x 1 matrix 1. The set of rows changes only with the contact modes.
 */
final class Block {
    private static final int STRIDE = Particles.STRIDE;
    /** No row, surface or particle. */
    static final int NONE = -1;
    /** For {@link #solve} and {@link #take}: all rows. */
    static final int ALL = -2;

    final int[] members;                                // rows of rods, wires and balls, neighbours near each other
    final int[] particles;                              // that can move
    private final ConstraintRows rows;
    private final Particles all;
    private final RestingContacts contacts;
    private final ActiveSetMethod activeSet;
    private final EnvelopeMatrix matrix = new EnvelopeMatrix();
    final BitSet held = new BitSet();                   // particles that do not move
    final ContactRows touching;
    double[] right = {};
    private double[] solution = {};
    private double[] separation = {};
    private int[] row = {};                             // a member, or -1 - k for contact k with a surface
    private int[] who = {};                             // two movable particles a row, -1 for none
    private double[] gradient = {};                     // 6 doubles a row
    private double[] pull = {};                         // the force on both particles per 1 N of a row
    private boolean[] mayOpen = {};
    private boolean[] active = {};
    private final int[] firstRow;                       // by place in particles; -1 for none yet
    private int size;
    private boolean pairs;
    private boolean assembled;                          // for the present gradients
    private int gatheredAt = NONE;                     // the modes' count of changes

    Block(int[] members, int[] particles, ConstraintRows rows, Particles all, RestingContacts contacts,
            ActiveSetMethod activeSet) {
        this.members = members;
        this.particles = particles;
        this.rows = rows;
        this.all = all;
        this.contacts = contacts;
        this.activeSet = activeSet;
        firstRow = new int[particles.length];
        touching = new ContactRows(contacts);
    }

    boolean isJoined() {
        return members.length > 0;
    }

    /**
     * Evaluates the rows at a state. The set of rows is found again only if a contact mode has changed since.
     *
     * @param held whether sticking particles are held: they do not move, and have no contacts; the same in each call
     */
    void take(double[] state, boolean held) {
        if (gatheredAt != contacts.getModes().getChanges()) {
            gather(held ? contacts.getModes()::isSticking : i -> false, NONE, NONE, ALL);
            gatheredAt = contacts.getModes().getChanges();
        }
        update(state);
    }

    /**
     * Takes a state in which given particles are held.
     *
     * @param surface the surface that a particle strikes, which gets a row too; {@link #NONE} for no impact
     * @param struck  that particle
     * @param pair    the two balls in contact that get a row; {@link #ALL} or {@link #NONE}
     */
    void take(double[] state, IntPredicate isHeld, int surface, int struck, int pair) {
        gather(isHeld, surface, struck, pair);
        update(state);
    }

    /** Finds the rows. */
    private void gather(IntPredicate isHeld, int surface, int struck, int pair) {
        gatheredAt = NONE;
        assembled = false;
        size = 0;
        pairs = false;
        matrix.clear();
        touching.clear();
        held.clear();
        Arrays.fill(firstRow, -1);
        Arrays.stream(particles).filter(isHeld).forEach(held::set);
        for (int member : Arrays.stream(members).filter(m -> pair == ALL || pair == m || !rows.isContact(m))
                .toArray()) {
            int from = rows.first(member);
            int to = rows.second(member);
            boolean isFromNew = isNew(from);
            boolean isToNew = isNew(to);
            add(member, from, to);
            addContacts(isFromNew ? from : -1, surface, struck);
            addContacts(isToNew ? to : -1, surface, struck);
        }
        for (int i : particles) {
            addContacts(isNew(i) ? i : -1, surface, struck);
        }
        Arrays.fill(active, true);
    }

    private boolean isNew(int i) {
        return canMove(i) && firstRow[Arrays.binarySearch(particles, i)] < 0;
    }

    private boolean canMove(int i) {
        return i >= 0 && all.getInverseMasses()[i] != 0 && !held.get(i);
    }

    private void add(int index, int first, int second) {
        if (size == row.length) {
            int more = 2 * size + 1;
            row = Arrays.copyOf(row, more);
            who = Arrays.copyOf(who, 2 * more);
            gradient = new double[6 * more];
            pull = new double[6 * more];
            mayOpen = new boolean[more];
            active = new boolean[more];
            right = new double[more];
            solution = new double[more];
            separation = new double[more];
        }
        row[size] = index;
        pairs |= isPair(size);
        matrix.add(Math.min(join(0, first), join(1, second)));
        size++;
    }

    /** Makes a movable particle the k-th of the new row; returns the first row that moves it too. */
    private int join(int k, int i) {
        who[2 * size + k] = canMove(i) ? i : -1;
        int place = Arrays.binarySearch(particles, i);
        if (canMove(i) && firstRow[place] < 0) {
            firstRow[place] = size;
        }
        return canMove(i) ? firstRow[place] : size;
    }

    /** Adds a row for each surface that a movable particle touches, and for the one that it strikes. */
    private void addContacts(int i, int surface, int struck) {
        for (int p = 0; canMove(i) && p < contacts.getSurfaces().size(); p++) {
            if (p == surface && i == struck || contacts.getModes().get(p, i) != Mode.FREE) {
                add(-1 - touching.add(p, i), i, -1);
            }
        }
    }

    /** Evaluates the rows; those of rods, wires and balls have been evaluated already. */
    private void update(double[] state) {
        assembled &= size == 1 && !isJoined();          // then the matrix is 1
        for (int r = 0; r < size; r++) {
            if (isMember(r)) {
                System.arraycopy(rows.gradient, 6 * row[r], gradient, 6 * r, 6);
            } else {
                touching.update(contact(r), state, isJoined());
                System.arraycopy(touching.normal, 3 * contact(r), gradient, 6 * r, 3);
            }
        }
    }

    int size() {
        return size;
    }

    /** Whether a row is that of a rod, a wire or two balls, and not of a surface. */
    boolean isMember(int r) {
        return row[r] >= 0;
    }

    /** Whether a row is that of two balls in contact. */
    boolean isPair(int r) {
        return row[r] >= 0 && rows.isContact(row[r]);
    }

    /** Whether a row may only push: that of a surface or of two balls. */
    boolean isContact(int r) {
        return row[r] < 0 || isPair(r);
    }

    /** Whether some row is that of two balls in contact. */
    boolean hasPairs() {
        return pairs;
    }

    /** The row of a rod, a wire or two balls among all. */
    int member(int r) {
        return row[r];
    }

    /** The contact of a row. */
    int contact(int r) {
        return -1 - row[r];
    }

    /** Assembles the matrix. */
    private void assemble() {
        System.arraycopy(gradient, 0, pull, 0, 6 * size);
        for (int r = 0; r < size; r++) {
            if (row[r] < 0 && isJoined()) {
                pull[6 * r] -= touching.slip[3 * contact(r)];
                pull[6 * r + 1] -= touching.slip[3 * contact(r) + 1];
                pull[6 * r + 2] -= touching.slip[3 * contact(r) + 2];
            }
            for (int c = matrix.first(r); c <= r; c++) {
                matrix.set(r, c, c == r && row[r] < 0 ? weight(who[2 * r]) : entry(r, c), c == r ? 0 : entry(c, r));
            }
        }
    }

    /** W: 1/m, but 1 for a single particle, whose mass cancels, so that its rows are forces and not accelerations. */
    double weight(int i) {
        return isJoined() ? all.getInverseMasses()[i] : 1;
    }

    /** J' v of a contact, times its particle's mass if that is single. */
    double bend(int k) {
        return isJoined() ? touching.bend[k] : all.mass(touching.particle[k]) * touching.bend[k];
    }

    private double entry(int r, int c) {
        double sum = 0;
        for (int k = 0; k < 2; k++) {
            int i = who[2 * r + k];
            for (int l = 0; l < 2 && i >= 0; l++) {
                if (i == who[2 * c + l]) {
                    int g = 6 * r + 3 * k;
                    int p = 6 * c + 3 * l;
                    sum += weight(i) * (gradient[g] * pull[p] + gradient[g + 1] * pull[p + 1]
                            + gradient[g + 2] * pull[p + 2]);
                }
            }
        }
        return sum;
    }

    /** Whether no particle of a row can move, so that it is left out. */
    boolean isIdle(int r) {
        return who[2 * r] < 0 && who[2 * r + 1] < 0;
    }

    /**
     * Solves for {@link #right}.
     *
     * @param holding the row of a contact that may not separate, {@link #ALL} or {@link #NONE}
     * @param signed  as for {@link ActiveSetMethod#solve}
     */
    boolean solve(int holding, boolean signed) {
        if (!assembled) {
            assemble();
            assembled = size == 1;
        }
        if (!pairs || gatheredAt == NONE) {
            Arrays.fill(active, true);                  // balls in contact push as they did before
        }
        for (int r = 0; r < size; r++) {
            mayOpen[r] = isContact(r) && r != holding && holding != ALL;
        }
        return activeSet.solve(matrix, right, mayOpen, signed, active, solution, separation);
    }

    /** The force of a row in the solution. */
    double force(int r) {
        return solution[r];
    }

    /** The separating acceleration of a row (m/s&sup2;), force of a single particle (N), or speed after an impact. */
    double separation(int r) {
        return separation[r];
    }

    /** The row of a contact; -1 if there is none. */
    int find(int surface, int particle) {
        for (int r = 0; r < size; r++) {
            if (row[r] < 0 && touching.surface[contact(r)] == surface && touching.particle[contact(r)] == particle) {
                return r;
            }
        }
        return -1;
    }

    /** Adds the forces of all rows, with friction. */
    void addForces(double[] force) {
        for (int r = 0; r < size; r++) {
            if (row[r] >= 0) {
                rows.addForce(row[r], solution[r], force);
            } else {
                touching.addForce(contact(r), solution[r], force);
            }
        }
    }

    /**
     * Moves the block's particles along the rows by the solution, without friction.
     *
     * @param place 0 to move positions, 3 to change velocities
     */
    void move(double[] state, int place) {
        for (int r = 0; r < size; r++) {
            for (int k = 0; k < 2; k++) {
                int i = who[2 * r + k];
                for (int c = 0; c < 3 && i >= 0; c++) {
                    state[STRIDE * i + place + c] += weight(i) * solution[r] * gradient[6 * r + 3 * k + c];
                }
            }
        }
    }
}
