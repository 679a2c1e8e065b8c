package particles.reactions;

import java.util.Arrays;
import java.util.BitSet;
import java.util.function.IntPredicate;
import particles.law.Particles;
import particles.reactions.Rows.Kind;
import particles.reactions.algebra.ActiveSetMethod;
import particles.reactions.algebra.EnvelopeMatrix;
import particles.reactions.contact.ContactModes.Mode;

/**
 * A block: the particles connected by rods, wires and contacts of balls, or one particle without any, and the linear
 * system of their reaction forces. It has a row for each rod and each contact, and two for each particle on a wire. Two
 * balls in contact have the row of a rod that may only push. Column c of the matrix is the acceleration of all rows if
 * row c has a force of 1 N. The force of a sliding contact includes friction, -S<sup>T</sup> lambda, so the matrix A =
 * J W (J - S)<sup>T</sup> is not symmetric. It has entries only where two rows share a movable particle. A particle's
 * contacts come right after its first rod, so the envelope of a chain is narrow. A held particle has no contacts, since
 * it does not move at all. A single particle on one surface has the 1 x 1 matrix 1. The set of rows changes only with
 * the contact modes.
 */
final class Block {
    private static final int STRIDE = Particles.STRIDE;
    /** No row or pair of balls. */
    static final int NONE = -1;
    /** For {@link #solve} and {@link #take}: all rows. */
    static final int ALL = -2;

    final int[] members;                                // rows of rods, wires and balls, neighbours near each other
    final int[] particles;                              // that can move
    final Rows rows = new Rows();
    final BitSet held = new BitSet();                   // particles that do not move
    private final Rows all;
    private final Particles system;
    private final RestingContacts contacts;
    private final IntPredicate usuallyHeld;
    private final ActiveSetMethod activeSet;
    private final EnvelopeMatrix matrix = new EnvelopeMatrix();
    private final boolean hasPairs;
    private final BitSet placed = new BitSet();         // particles whose contacts have rows
    private int struckSurface = NONE;                   // has a row for one particle that it does not touch yet
    private int struckParticle = NONE;
    double[] right = {};
    private double[] solution = {};
    private double[] separation = {};
    private int[] movable = {};                         // two particles a row, NONE for those that do not move
    private boolean[] mayOpen = {};
    private boolean[] active = {};
    private boolean assembled;                          // for the present gradients
    private int gatheredAt = NONE;                      // the modes' count of changes

    /**
     * @param members     rows of {@code all}
     * @param particles   the particles that they move, in ascending order
     * @param usuallyHeld the particles that are held in most uses; their number changes only with the modes
     */
    Block(int[] members, int[] particles, Rows all, Particles system, RestingContacts contacts,
            IntPredicate usuallyHeld, ActiveSetMethod activeSet) {
        this.members = members;
        this.particles = particles;
        this.all = all;
        this.system = system;
        this.contacts = contacts;
        this.usuallyHeld = usuallyHeld;
        this.activeSet = activeSet;
        hasPairs = Arrays.stream(members).anyMatch(r -> all.kind[r] == Kind.BALLS);
    }

    boolean isJoined() {
        return members.length > 0;
    }

    /** Whether some row is that of two balls in contact. */
    boolean hasPairs() {
        return hasPairs;
    }

    /**
     * Evaluates the rows at a state. Their set is found again only if a contact mode has changed since.
     *
     * @param pairs the pairs of balls in contact that get a row: {@link #ALL} or {@link #NONE}
     */
    void take(double[] state, int pairs) {
        if (hasPairs && pairs == NONE) {
            take(state, usuallyHeld, NONE);
            return;
        }
        if (gatheredAt != contacts.getModes().getChanges()) {
            gather(usuallyHeld, ALL);
            gatheredAt = contacts.getModes().getChanges();
        }
        evaluate(state);
    }

    /**
     * Evaluates the rows while given particles are held.
     *
     * @param pair the two balls in contact that get a row; {@link #ALL} or {@link #NONE}
     */
    void take(double[] state, IntPredicate isHeld, int pair) {
        gather(isHeld, pair);
        evaluate(state);
    }

    /** Evaluates the rows with that of an impact of a particle on a surface, which is returned; balls have no rows. */
    int takeForImpact(int surface, int particle, double[] state) {
        struckSurface = surface;
        struckParticle = particle;
        try {
            take(state, i -> false, NONE);
        } finally {
            struckParticle = NONE;
        }
        return find(Kind.SURFACE, surface, particle);
    }

    /** Finds the rows. */
    private void gather(IntPredicate isHeld, int pair) {
        gatheredAt = NONE;
        assembled = false;
        rows.clear();
        held.clear();
        placed.clear();
        Arrays.stream(particles).filter(isHeld).forEach(held::set);
        for (int member : members) {
            if (pair == ALL || pair == member || all.kind[member] != Kind.BALLS) {
                rows.add(all, member);
                addContacts(all.first[member]);
                addContacts(all.second[member]);
            }
        }
        for (int i : particles) {
            addContacts(i);
        }
        if (right.length < rows.count) {
            int most = rows.kind.length;
            right = new double[most];
            solution = new double[most];
            separation = new double[most];
            movable = new int[2 * most];
            mayOpen = new boolean[most];
            active = new boolean[most];
        }
        Arrays.fill(active, true);
        layOut();
    }

    /** Adds a row for each surface that a movable particle touches, the first time. */
    private void addContacts(int i) {
        if (canMove(i) && !placed.get(i)) {
            placed.set(i);
            for (int p = 0; p < contacts.getSurfaces().size(); p++) {
                if (contacts.getModes().get(p, i) != Mode.FREE || i == struckParticle && p == struckSurface) {
                    rows.addContact(i, p, contacts.getSurfaces().get(p));
                }
            }
        }
    }

    private boolean canMove(int i) {
        return i >= 0 && system.getInverseMasses()[i] != 0 && !held.get(i);
    }

    /** Finds the envelope of the matrix: a row's begins with the first row that moves one of its particles. */
    private void layOut() {
        int[] firstRow = new int[particles.length];
        Arrays.fill(firstRow, rows.count);
        matrix.clear();
        for (int r = 0; r < rows.count; r++) {
            int begin = r;
            for (int k = 0; k < 2; k++) {
                int i = (k == 0 ? rows.first : rows.second)[r];
                movable[2 * r + k] = canMove(i) ? i : NONE;
                if (canMove(i)) {
                    int place = Arrays.binarySearch(particles, i);
                    firstRow[place] = Math.min(firstRow[place], r);
                    begin = Math.min(begin, firstRow[place]);
                }
            }
            matrix.add(begin);
        }
    }

    /** A single particle needs no distances, and its matrix stays 1 on one surface. */
    private void evaluate(double[] state) {
        assembled &= rows.count == 1 && !isJoined();
        rows.evaluate(state, isJoined());
        for (int r = 0; r < rows.count && !isJoined(); r++) {
            rows.bend[r] *= system.mass(particles[0]);
        }
    }

    /** Whether a row may only push: that of a surface or of two balls. */
    boolean isContact(int r) {
        return rows.kind[r] == Kind.SURFACE || rows.kind[r] == Kind.BALLS;
    }

    /** Assembles the matrix. */
    private void assemble() {
        for (int r = 0; r < rows.count; r++) {
            for (int c = matrix.first(r); c <= r; c++) {
                matrix.set(r, c, c == r && rows.kind[r] == Kind.SURFACE ? weight(rows.first[r]) : entry(r, c),
                        c == r ? 0 : entry(c, r));
            }
        }
    }

    /** W: 1/m, but 1 for a single particle, whose mass cancels, so that its rows are forces and not accelerations. */
    double weight(int i) {
        return isJoined() ? system.getInverseMasses()[i] : 1;
    }

    private double entry(int r, int c) {
        double sum = 0;
        for (int k = 0; k < 2; k++) {
            int i = movable[2 * r + k];
            for (int l = 0; l < 2 && i >= 0; l++) {
                if (i == movable[2 * c + l]) {
                    sum += weight(i) * Rows.dot(rows.gradient, 6 * r + 3 * k, rows.pull, 6 * c + 3 * l);
                }
            }
        }
        return sum;
    }

    /** Whether no particle of a row can move, so that it is left out. */
    boolean isIdle(int r) {
        return movable[2 * r] < 0 && movable[2 * r + 1] < 0;
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
            assembled = rows.count == 1;
        }
        if (!hasPairs || gatheredAt == NONE) {
            Arrays.fill(active, true);                  // balls in contact push as they did before
        }
        for (int r = 0; r < rows.count; r++) {
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

    /** The row of a kind with a number and a first particle; -1 if there is none. */
    int find(Kind kind, int number, int particle) {
        int r = rows.count - 1;
        while (r >= 0 && (rows.kind[r] != kind || rows.number[r] != number || rows.first[r] != particle)) {
            r--;
        }
        return r;
    }

    /** Adds the forces of all rows, with friction. */
    void addForces(double[] force) {
        for (int r = 0; r < rows.count; r++) {
            rows.addForce(r, solution[r], force);
        }
    }

    /** The power of the friction in the solution (W); surfaces at rest do no other work. */
    double frictionPower(double[] state) {
        double power = 0;
        for (int r = 0; r < rows.count; r++) {
            power += solution[r] * rows.frictionPower(r, state);
        }
        return power;
    }

    /** The power with which moving anchors drive the rods in the solution (W). */
    double anchorPower(double[] state) {
        double power = 0;
        for (int r = 0; r < rows.count; r++) {
            power -= solution[r] * rows.rateOfAnchors(r, state, system.getInverseMasses());
        }
        return power;
    }

    /**
     * Moves the block's particles along the rows by the solution, without friction.
     *
     * @param place 0 to move positions, 3 to change velocities
     */
    void move(double[] state, int place) {
        for (int r = 0; r < rows.count; r++) {
            for (int k = 0; k < 2; k++) {
                int i = movable[2 * r + k];
                for (int c = 0; c < 3 && i >= 0; c++) {
                    state[STRIDE * i + place + c] += weight(i) * solution[r] * rows.gradient[6 * r + 3 * k + c];
                }
            }
        }
    }
}
