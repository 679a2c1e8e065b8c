package particles.reactions;

import deSolvers.linear.EnvelopeMatrix;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Comparator;
import java.util.List;
import java.util.function.IntPredicate;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import particles.SimulationException;
import particles.law.Particles;
import particles.reactions.BlockImpacts.Meeting;
import particles.reactions.ContactModes.Mode;
import particles.reactions.Row.Kind;

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
    /** No particle, surface or pair of balls. */
    static final int NONE = -1;
    /** All pairs of balls. */
    static final int ALL = -2;

    final int[] members;                                // rows of rods, wires and balls, neighbours near each other
    final int[] particles;                              // that can move
    Row[] rows = {};
    BitSet held = new BitSet();                         // particles that do not move
    private final Rows all;
    private final Particles system;
    private final RestingContacts contacts;
    private final IntPredicate usuallyHeld;
    private final ActiveSetMethod activeSet;
    private final EnvelopeMatrix matrix = new EnvelopeMatrix();
    private final boolean hasPairs;
    final double massRatio;                             // the largest by the smallest
    private final BitSet placed = new BitSet();         // particles whose contacts have rows
    private List<Meeting> meetings = List.of();         // have rows, although they do not touch yet
    private double[] right = {};
    private double[] solution = {};
    private double[] separation = {};
    private boolean[] mayOpen = {};
    private boolean[] active = {};
    private boolean[] first = {};                       // those that were active as the step began
    private int firstAt = NONE;                         // the number of that step
    private boolean assembled;                          // for the present gradients
    private int gatheredAt = NONE;                      // the modes' count of changes
    private BitSet usual = held;                        // particles that are held in most uses
    private int usualAt = NONE;

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
        double[] weights = Arrays.stream(particles).mapToDouble(this::weight).sorted().toArray();
        massRatio = weights.length == 0 ? 1 : weights[weights.length - 1] / weights[0];
        hasPairs = Arrays.stream(members).anyMatch(r -> all.get(r).kind == Kind.BALLS);
    }

    boolean isJoined() {
        return members.length > 0;
    }

    /** Whether some row is that of two balls in contact. */
    boolean hasPairs() {
        return hasPairs;
    }

    /**
     * Evaluates the rows at a state, while the usual particles are held.
     *
     * @param pairs the pairs of balls in contact that get a row: {@link #ALL} or {@link #NONE}
     */
    void take(double[] state, int pairs) {
        if (usualAt != contacts.getModes().getChanges()) {
            usualAt = contacts.getModes().getChanges();
            usual = where(usuallyHeld);
        }
        take(state, usual, pairs);
    }

    /** The particles of the block with a property. */
    BitSet where(IntPredicate property) {
        BitSet found = new BitSet();
        for (int i : particles) {
            found.set(i, property.test(i));
        }
        return found;
    }

    /**
     * Evaluates the rows while given particles are held. Their set is found again only if a contact mode has changed
     * since, or others are held.
     *
     * @param pair the two balls in contact that get a row; {@link #ALL} or {@link #NONE}
     */
    void take(double[] state, BitSet nowHeld, int pair) {
        int changes = contacts.getModes().getChanges();
        boolean lasts = !hasPairs || nowHeld == usual && pair == ALL;
        if (!lasts || gatheredAt != changes || !held.equals(nowHeld)) {
            held = nowHeld;
            gather(pair);
            gatheredAt = lasts ? changes : NONE;
        }
        evaluate(state);
    }

    /** Evaluates all rows, with those of particles that meet a surface; none is held. */
    void takeForImpact(List<Meeting> meeting, double[] state) {
        meetings = meeting;
        gatheredAt = NONE;
        take(state, new BitSet(), ALL);
        meetings = List.of();
        gatheredAt = NONE;
    }

    /** Solves for these rows only, until they are taken again. */
    void keep(Stream<Row> kept) {
        rows = kept.toArray(Row[]::new);
        assembled = false;
        layOut();
    }

    /** Finds the rows. */
    private void gather(int pair) {
        assembled = false;
        placed.clear();
        List<Row> found = new ArrayList<>();
        for (int member : members) {
            Row row = all.get(member);
            if (pair == ALL || pair == member || row.kind != Kind.BALLS) {
                found.add(row.numbered(member));
                addContacts(row.first, found);
                addContacts(row.second, found);
            }
        }
        for (int i : particles) {
            addContacts(i, found);
        }
        rows = found.toArray(new Row[0]);
        if (right.length < rows.length) {
            int most = 2 * rows.length;
            right = new double[most];
            solution = new double[most];
            separation = new double[most];
            mayOpen = new boolean[most];
            active = new boolean[most];
        }
        Arrays.fill(active, true);
        firstAt = NONE;
        layOut();
    }

    /** Adds a row for each surface that a movable particle touches, the first time. */
    private void addContacts(int i, List<Row> found) {
        if (canMove(i) && !placed.get(i)) {
            placed.set(i);
            for (int p = 0; p < contacts.getSurfaces().size(); p++) {
                if (contacts.getModes().get(p, i) != Mode.FREE || isMet(p, i)) {
                    found.add(Row.contact(i, p, contacts.getSurfaces().get(p)));
                }
            }
        }
    }

    private boolean isMet(int surface, int i) {
        return meetings.stream().anyMatch(meeting -> meeting.surface() == surface && meeting.particle() == i);
    }

    private boolean canMove(int i) {
        return i >= 0 && system.getInverseMasses()[i] != 0 && !held.get(i);
    }

    /** Finds the envelope of the matrix: a row's begins with the first row that moves one of its particles. */
    private void layOut() {
        int[] firstRow = new int[particles.length];
        Arrays.fill(firstRow, rows.length);
        matrix.clear();
        for (int r = 0; r < rows.length; r++) {
            int begin = r;
            for (int k = 0; k < 2; k++) {
                int i = rows[r].particle(k);
                if (canMove(i)) {
                    rows[r].movable[k] = i;
                    int place = Arrays.binarySearch(particles, i);
                    firstRow[place] = Math.min(firstRow[place], r);
                    begin = Math.min(begin, firstRow[place]);
                }
            }
            matrix.add(begin);
        }
    }

    /** The matrix of a single particle stays 1 on one surface. */
    void evaluate(double[] state) {
        assembled &= rows.length == 1 && !isJoined();
        for (Row row : rows) {
            row.evaluate(state);
            row.bend *= isJoined() ? 1 : system.mass(particles[0]);
        }
    }

    /** Assembles the matrix. */
    private void assemble() {
        for (int r = 0; r < rows.length; r++) {
            Row row = rows[r];
            for (int c = matrix.first(r); c <= r; c++) {
                matrix.set(r, c, c == r && row.kind == Kind.SURFACE ? weight(row.first) : entry(row, rows[c]),
                        c == r ? 0 : entry(rows[c], row));
            }
        }
    }

    /** W: 1/m, but 1 for a single particle, whose mass cancels, so that its rows are forces and not accelerations. */
    double weight(int i) {
        return isJoined() ? system.getInverseMasses()[i] : 1;
    }

    private double entry(Row row, Row column) {
        double sum = 0;
        for (int k = 0; k < 2; k++) {
            int i = row.movable[k];
            for (int l = 0; l < 2 && i >= 0; l++) {
                if (i == column.movable[l]) {
                    sum += weight(i) * Row.dot(row.gradient, 3 * k, column.pull, 3 * l);
                }
            }
        }
        return sum;
    }

    /**
     * Finds the forces and separations of all rows for their entries of b.
     *
     * @param separates which contacts may separate
     * @param signed    as for {@link ActiveSetMethod#solve}
     */
    boolean solve(Predicate<Row> separates, boolean signed) {
        if (!assembled) {
            assemble();
            assembled = rows.length == 1;
        }
        if (!hasPairs || gatheredAt == NONE) {
            Arrays.fill(active, true);
        } else if (firstAt != contacts.getSliding().getStep()) {
            firstAt = contacts.getSliding().getStep();
            first = active.clone();
        } else {                                        // the same state has the same forces, to the last digit
            System.arraycopy(first, 0, active, 0, first.length);
        }
        for (int r = 0; r < rows.length; r++) {
            right[r] = rows[r].right;
            mayOpen[r] = rows[r].isContact() && separates.test(rows[r]);
        }
        activeSet.setMassRatio(massRatio);
        boolean solved = activeSet.solve(matrix, right, mayOpen, signed, active, solution, separation);
        for (int r = 0; r < rows.length; r++) {
            rows[r].force = solution[r];
            rows[r].separation = separation[r];
        }
        return solved;
    }

    /** Adds the forces of all rows, with friction. */
    void addForces(double[] force) {
        for (Row row : rows) {
            row.addForce(force);
        }
    }

    /**
     * Moves the block's particles along the rows by the solution, without friction.
     *
     * @param place 0 to move positions, 3 to change velocities
     */
    void move(double[] state, int place) {
        for (Row row : rows) {
            for (int k = 0; k < 2; k++) {
                int i = row.movable[k];
                for (int c = 0; c < 3 && i >= 0; c++) {
                    state[STRIDE * i + place + c] += weight(i) * row.force * row.gradient[3 * k + c];
                }
            }
        }
    }

    /** The error that ends a run where no forces or impulses satisfy the conditions. */
    SimulationException failure(double time, String reason) {
        String what = Arrays.stream(rows).map(row -> row.isContact() ? "contacts" : "rods and wires").distinct()
                .sorted(Comparator.reverseOrder()).collect(Collectors.joining(" and "));
        return new SimulationException(time, particles[0], "the " + what + " connected to particle '"
                + system.id(particles[0]) + "' " + reason, null);
    }
}
