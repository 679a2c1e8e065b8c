package particles.reactions;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.IntPredicate;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import particles.ParticleSystem;
import particles.SimulationException;
import particles.law.Particles;
import particles.reactions.Row.Kind;

/**
 * The blocks of a system and their reaction forces, one block at a time, see the {@linkplain particles.reactions
 * theory}: normal forces, friction and the forces of rods, wires and balls in contact, which depend on each other. A
 * sticking particle does not move; its contact force balances all others.
 */
final class Blocks {
    private static final int STRIDE = Particles.STRIDE;

    private final ParticleSystem system;
    private final Particles particles;
    private final Rows rows;
    private final RestingContacts contacts;
    private final double feedback;
    private final IntPredicate usuallyHeld;
    private final LoneContacts lone;
    private final ActiveSetMethod activeSet = new ActiveSetMethod();
    private final List<Block> singles = new ArrayList<>();
    private final List<Block> joined = new ArrayList<>();
    private Block[] blockOf = {};                       // by particle; null for one that is not coupled
    private int joinedAt = -1;                          // the rows' count of changes
    private double[] accelerations = {};
    private double[] total = {};                        // forces including those of rods, wires and contacts
    private int solutions;
    private double left;                                // the residual of the last solution, relative to accelerations

    /**
     * @param rows        the rods, wires and contacts of balls
     * @param feedback    the rate at which their errors decay (1/s)
     * @param usuallyHeld the particles that are held while forces act
     */
    Blocks(ParticleSystem system, Rows rows, double feedback, RestingContacts contacts, IntPredicate usuallyHeld) {
        this.system = system;
        this.particles = system.getParticles();
        this.rows = rows;
        this.contacts = contacts;
        this.feedback = feedback;
        this.usuallyHeld = usuallyHeld;
        lone = new LoneContacts(this, contacts, particles);
    }

    Rows getRows() {
        return rows;
    }

    LoneContacts getLone() {
        return lone;
    }

    /** The blocks of coupled particles. */
    List<Block> joined() {
        if (joinedAt != rows.getChanges()) {
            joinedAt = rows.getChanges();
            joined.clear();
            blockOf = new Block[particles.count()];
            for (int[] part : rows.parts(particles)) {
                Block block = block(part, Arrays.stream(part).mapToObj(rows::get)
                        .flatMapToInt(row -> IntStream.of(row.first, row.second))
                        .filter(i -> i >= 0 && !particles.isFixed(i)).distinct().sorted().toArray());
                joined.add(block);
                Arrays.stream(block.particles).forEach(i -> blockOf[i] = block);
            }
        }
        return joined;
    }

    /** A block of some rows and particles. */
    Block block(int[] members, int... movable) {
        return new Block(members, movable, rows, particles, contacts, usuallyHeld, activeSet);
    }

    /** Whether a particle is on a rod or wire, or in contact with a ball. */
    boolean isCoupled(int particle) {
        joined();
        return particle < blockOf.length && blockOf[particle] != null;
    }

    /** Whether no particle of a row moves while forces act. */
    boolean isHeld(Row row) {
        return IntStream.of(row.first, row.second).allMatch(i -> i < 0 || particles.isFixed(i) || usuallyHeld.test(i));
    }

    /** The block of a particle. */
    Block of(int particle) {
        if (isCoupled(particle)) {
            return blockOf[particle];
        }
        while (singles.size() <= particle) {
            singles.add(block(new int[0], singles.size()));
        }
        return singles.get(particle);
    }

    /** Prepares for a state, once for all blocks. */
    void prepare(double[] state, double time) {
        accelerations = accelerations.length < state.length ? new double[state.length] : accelerations;
        system.putAnchorAccelerations(time, accelerations);
    }

    /**
     * Adds the forces of a block, after {@link #prepare}.
     *
     * @param force the forces of all effects (N)
     * @param power what the power of each row is (W)
     * @return the sum of the powers (W)
     */
    double addForces(Block block, double[] state, double time, double[] force, ToDoubleFunction<Row> power) {
        double sum = power(block, state, time, force, power);
        block.addForces(force);
        ConstraintCorrection.addRest(this, block, force);
        for (int i = block.held.nextSetBit(0); i >= 0; i = block.held.nextSetBit(i + 1)) {
            Arrays.fill(force, STRIDE * i + 3, STRIDE * (i + 1), 0.0);
        }
        return sum;
    }

    /** The sum of a power over the rows of a block (W), after {@link #prepare}. */
    private double power(Block block, double[] state, double time, double[] force, ToDoubleFunction<Row> power) {
        solve(block, state, time, force);
        double sum = 0;
        for (Row row : block.rows) {
            sum += power.applyAsDouble(row);
        }
        return sum;
    }

    /** Adds the forces of all coupled particles to those of all effects (N). */
    void addForces(double[] state, double time, double[] force) {
        prepare(state, time);
        joined().forEach(block -> addForces(block, state, time, force, row -> 0));
    }

    /** The sum of a power over the rows of all coupled particles (W). */
    double power(double[] state, double time, double[] force, ToDoubleFunction<Row> power) {
        prepare(state, time);
        return joined().stream().mapToDouble(block -> power(block, state, time, force, power)).sum();
    }

    /**
     * Finds the forces of a block, after {@link #prepare}.
     *
     * @param force the forces of all effects (N)
     * @throws SimulationException if friction jams or rods contradict each other while no particle sticks. If one
     *         sticks that is no error: a rule releases it at the start of the motion
     */
    void solve(Block block, double[] state, double time, double[] force) {
        block.take(state, Block.ALL);
        Optional<String> failure = solve(block, state, force);
        if (failure.isPresent() && block.held.isEmpty()) {
            throw block.failure(time, failure.get());
        }
    }

    /** Counts solutions: the last one is still at hand if the number has not changed. */
    int getSolutions() {
        return solutions;
    }

    /** The residual of the last solution, relative to accelerations. */
    double getLeft() {
        return left;
    }

    /** Finds all forces for the rows that were taken just before; returns the reason if there are none. */
    Optional<String> solve(Block block, double[] state, double[] force) {
        solutions++;
        left = 0;
        if (block.rows.length == 0) {                   // all its particles are held
            return Optional.empty();
        }
        boolean isIndirect = contacts.getSliding().isIndirect(block.rows, state);
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
        for (Row row : block.rows) {
            contacts.getSliding().add(block.rows, row, isIndirect, isIndirect ? total : force, state);
        }
        // friction acts along all surfaces of a particle: it does not change how hard they push a single one
        return block.isJoined() ? solveOnce(block, force) : Optional.empty();
    }

    private Optional<String> solveOnce(Block block, double[] force) {
        putRight(block, force);
        if (!block.solve(row -> true, block.hasPairs() || !contacts.isHolding())) {
            return Optional.of(ConstraintCorrection.areUneven(block) ? ConstraintCorrection.LOST
                    : "let no contact forces keep all particles out: friction or a moving anchor jams them");
        }
        left = activeSet.getLeft() == 0 ? 0 : activeSet.getLeft() / scale(block, force);
        return left > Tolerances.NO_SOLUTION ? Optional.of("contradict each other: no forces can satisfy them all")
                : Optional.empty();
    }

    /**
     * b = -(J W F + J' v) - k_s C - k_d C', with C the distance for contacts. Where balls touch, contacts have no
     * feedback: in a dense packing, the errors of many could not decay at the same time.
     */
    void putRight(Block block, double[] force) {
        findAccelerations(block, force);
        for (Row row : block.rows) {
            double decay = !block.isJoined() || row.isContact() && block.hasPairs() ? 0 : feedback;
            row.right = row.isIdle() ? 0 : -(row.times(accelerations, 3) + row.bend)
                    - decay * decay * row.value - 2 * decay * row.rate;
        }
    }

    /** W F of the particles that are not held. */
    private void findAccelerations(Block block, double[] force) {
        for (int i : block.particles) {
            double w = block.held.get(i) ? 0 : block.weight(i);
            for (int f = STRIDE * i + 3; f < STRIDE * (i + 1); f++) {
                accelerations[f] = w * force[f];
            }
        }
    }

    /**
     * The push of a contact in the last solution (N), or minus the acceleration with which it separates. Where balls
     * touch, an acceleration of 0 counts as a small push, but for round-off: one more contact may do no harm.
     */
    double push(Block block, Row row, double[] force) {
        boolean pushes = block.hasPairs() ? row.force > 0 : row.force != 0;
        double rounding = block.hasPairs() ? Tolerances.STILL * scale(block, force) : 0;
        return pushes ? row.force : rounding - row.separation;
    }

    /** The largest acceleration in the equations of a block. */
    private double scale(Block block, double[] force) {
        findAccelerations(block, force);
        double scale = 0;
        for (int i : block.particles) {
            for (int f = STRIDE * i + 3; f < STRIDE * (i + 1); f++) {
                scale = Math.max(scale, Math.abs(accelerations[f]));
            }
        }
        for (Row row : block.rows) {
            scale = Math.max(scale, Math.abs(row.right));
        }
        return scale;
    }

    /** Sums the forces of effects, rods, wires and contacts, for the particles of a block. */
    double[] addUp(Block block, double[] force) {
        total = total.length == force.length ? total : new double[force.length];
        for (int i : block.particles) {
            System.arraycopy(force, STRIDE * i + 3, total, STRIDE * i + 3, 3);
        }
        block.addForces(total);
        return total;
    }

    /** The accelerations of moving anchors at the prepared state, in the entries of their velocities (m/s&sup2;). */
    double[] getAccelerations() {
        return accelerations;
    }

    /**
     * Corrects positions or velocities by C or C': on rods, wires, touched surfaces and, if they are meant, balls.
     *
     * @param place   0 for positions, 3 for velocities
     * @param mayOpen whether particles may leave contacts
     * @param pairs   the pairs of balls in contact that are meant: {@link Block#ALL} or {@link Block#NONE}
     */
    void correct(Block block, double[] state, int place, boolean mayOpen, int pairs) {
        block.take(state, pairs);
        correctTaken(block, state, place, mayOpen);
    }

    /** As {@link #correct}, for the rows that were taken. */
    void correctTaken(Block block, double[] state, int place, boolean mayOpen) {
        putErrors(block, place);
        block.solve(row -> mayOpen, mayOpen);
        block.move(state, place);
    }

    /** b = -C, or -C' for velocities. The last solution is no longer at hand. */
    void putErrors(Block block, int place) {
        solutions++;
        for (Row row : block.rows) {
            row.right = row.isIdle() ? 0 : -(place == 0 ? row.value : row.rate);
        }
    }
}
