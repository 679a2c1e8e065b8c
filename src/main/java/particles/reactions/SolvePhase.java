package particles.reactions;

import java.util.Arrays;
import java.util.Comparator;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import particles.SimulationException;
import particles.law.Particles;

/**
 * The third phase, which solves for the forces or impulses of a block's rows, by one active-set method: normal forces,
 * friction and the forces of rods, wires and balls in contact, which depend on each other, see the {@linkplain
 * particles.reactions theory}.
 */
final class SolvePhase {
    /** Why there is no solution where masses are very uneven. */
    private static final String LOST = "join masses that differ by a factor of more than 1e12: what the lightest pass"
            + " on is lost in round-off";
    private static final String JAMMED =
            "let no contact forces keep all particles out: friction or a moving anchor jams them";

    final Contacts contacts;
    final GatherPhase gather;
    final EvaluatePhase evaluate;
    private final ActiveSetMethod activeSet = new ActiveSetMethod();
    private double[] total = {};                        // forces including those of rods, wires and contacts

    SolvePhase(Contacts contacts) {
        this.contacts = contacts;
        gather = new GatherPhase(contacts);
        evaluate = new EvaluatePhase(contacts);
    }

    /**
     * Finds the forces and separations of all rows for their entries of b.
     *
     * @param separates which contacts may separate
     * @param signed    as for {@link ActiveSetMethod#solve}
     */
    boolean solve(Block block, Predicate<Row> separates, boolean signed) {
        evaluate.assemble(block);
        block.solutions++;
        if (!block.hasPairs || block.gatheredAt == Block.NEVER) {
            Arrays.fill(block.active, true);
        } else if (block.firstAt != contacts.getStep()) {
            block.firstAt = contacts.getStep();
            block.first = block.active.clone();
        } else {                                        // the same state has the same forces, to the last digit
            System.arraycopy(block.first, 0, block.active, 0, block.first.length);
        }
        Row[] rows = block.rows;
        double[] right = new double[rows.length];
        double[] solution = new double[rows.length];
        double[] separation = new double[rows.length];
        boolean[] mayOpen = new boolean[rows.length];
        for (int r = 0; r < rows.length; r++) {
            right[r] = rows[r].right;
            mayOpen[r] = rows[r].isContact() && separates.test(rows[r]);
        }
        activeSet.setMassRatio(block.massRatio);
        boolean solved = activeSet.solve(block.matrix, right, mayOpen, signed, block.active, solution, separation);
        for (int r = 0; r < rows.length; r++) {
            rows[r].force = solution[r];
            rows[r].separation = separation[r];
        }
        return solved;
    }

    /**
     * Finds the forces of a block while sticking particles are held.
     *
     * @param force the forces of all effects (N)
     * @throws SimulationException if friction jams or rods contradict each other while no particle sticks. If one
     *         sticks that is no error: a rule releases it at the start of the motion
     */
    void solveForces(Block block, double[] state, double time, double[] force) {
        gather.gather(block, true);
        Optional<String> failure = solveForces(block, state, force);
        if (failure.isPresent() && block.held.isEmpty()) {
            throw failure(block, time, failure.get());
        }
    }

    /** Finds all forces for the rows that were gathered; returns the reason if there are none. */
    Optional<String> solveForces(Block block, double[] state, double[] force) {
        evaluate.evaluate(block, state);
        block.left = 0;
        if (block.rows.length == 0) {                   // all its particles are held
            return Optional.empty();
        }
        boolean isIndirect = evaluate.sliding.isIndirect(block.rows, state);
        if (isIndirect || !block.isJoined()) {
            Optional<String> failure = solveOnce(block, force);
            if (failure.isPresent()) {
                return failure;
            }
        }
        if (isIndirect) {
            for (Row row : block.rows) {
                row.push = row.force;
            }
            addUp(block, force);
        }
        evaluate.addFriction(block, isIndirect, isIndirect ? total : force, state);
        // friction acts along all surfaces of a particle: it does not change how hard they push a single one
        return block.isJoined() ? solveOnce(block, force) : Optional.empty();
    }

    private Optional<String> solveOnce(Block block, double[] force) {
        evaluate.putForces(block, force);
        if (!solve(block, row -> true, block.hasPairs || !contacts.isHolding())) {
            return Optional.of(reason(block).orElse(JAMMED));
        }
        block.left = activeSet.getLeft() == 0 ? 0 : activeSet.getLeft() / evaluate.scale(block, force);
        return block.left > Tolerances.NO_SOLUTION
                ? Optional.of("contradict each other: no forces can satisfy them all") : Optional.empty();
    }

    /** The reason for no solution, if it is that the masses of a block differ too much. */
    static Optional<String> reason(Block block) {
        return block.massRatio > Tolerances.MOST_UNEVEN ? Optional.of(LOST) : Optional.empty();
    }

    /** The error that ends a run where no forces or impulses satisfy the conditions. */
    SimulationException failure(Block block, double time, String reason) {
        String what = Arrays.stream(block.rows).map(row -> row.isContact() ? "contacts" : "rods and wires").distinct()
                .sorted(Comparator.reverseOrder()).collect(Collectors.joining(" and "));
        return new SimulationException(time, block.particles[0], "the " + what + " connected to particle '"
                + contacts.particles.id(block.particles[0]) + "' " + reason, null);
    }

    /**
     * The push of a contact in the last solution (N), or minus the acceleration with which it separates. Where balls
     * touch, an acceleration of 0 counts as a small push, but for round-off: one more contact may do no harm.
     */
    double push(Block block, Row row, double[] force) {
        boolean pushes = block.hasPairs ? row.force > 0 : row.force != 0;
        double rounding = block.hasPairs ? Tolerances.STILL * evaluate.scale(block, force) : 0;
        return pushes ? row.force : rounding - row.separation;
    }

    /** Sums the forces of effects, rods, wires and contacts, for the particles of a block. */
    double[] addUp(Block block, double[] force) {
        total = total.length == force.length ? total : new double[force.length];
        for (int i : block.particles) {
            System.arraycopy(force, Particles.STRIDE * i + 3, total, Particles.STRIDE * i + 3, 3);
        }
        block.addForces(total);
        return total;
    }
}
