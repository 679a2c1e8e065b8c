package particles.reactions;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import particles.ParticleSystem;
import particles.SimulationException;
import particles.law.Particles;
import particles.law.Vector3;
import particles.reactions.algebra.ActiveSetMethod;
import particles.reactions.contact.ContactModes;
import particles.reactions.contact.ContactModes.Mode;

/**
 * The reaction forces of one block at a time, see the {@linkplain particles.reactions theory}: normal forces, friction
 * and the forces of rods, wires and balls in contact, which depend on each other. A sticking particle does not move;
 * its contact force balances all others.
 */
final class BlockForces {
    private static final int STRIDE = Particles.STRIDE;
    /**
     * Rods contradict each other if the residual is above this fraction of the largest acceleration; the drift of
     * redundant rods stays below.
     */
    private static final double CONTRADICTION = 1e-4;
    /**
     * Separations below this part of a block's largest acceleration are round-off, where balls touch: 1,000 times the
     * pull that the active-set method tolerates, as a pile pushes harder than its balls fall.
     */
    private static final double STILL = 1e-7;
    private static final String CONTRADICTORY = "contradict each other: no forces can satisfy them all";

    private final ParticleSystem system;
    private final Particles particles;
    private final ConstraintRows rows;
    private final RestingContacts contacts;
    private final ContactModes modes;
    private final double feedback;
    private final ActiveSetMethod activeSet = new ActiveSetMethod();
    private final List<Block> singles = new ArrayList<>();
    private double[] accelerations = {};
    private double[] total = {};                        // forces including those of rods, wires and contacts
    private int solutions;
    private double left;                                // the residual of the last solution, relative to accelerations

    BlockForces(ParticleSystem system, ConstraintRows rows, RestingContacts contacts, double feedback) {
        this.system = system;
        this.particles = system.getParticles();
        this.rows = rows;
        this.contacts = contacts;
        this.modes = contacts.getModes();
        this.feedback = feedback;
    }

    /** Makes a block of connected rows. */
    Block block(int[] members) {
        return new Block(members, Arrays.stream(members).flatMap(r -> IntStream.of(rows.first(r), rows.second(r)))
                .filter(i -> i >= 0 && !particles.isFixed(i)).distinct().sorted().toArray(), rows, particles, contacts,
                activeSet);
    }

    /** The block of a particle that is not coupled. */
    Block single(int particle) {
        while (singles.size() <= particle) {
            singles.add(new Block(new int[0], new int[] {singles.size()}, rows, particles, contacts, activeSet));
        }
        return singles.get(particle);
    }

    /** Prepares for a state, once for all blocks. */
    void prepare(double[] state, double time) {
        rows.evaluate(state);
        fit(state);
        system.putAnchorAccelerations(time, accelerations);
    }

    private void fit(double[] state) {
        accelerations = accelerations.length < state.length ? new double[state.length] : accelerations;
    }

    /**
     * Finds the forces of a block, after {@link #prepare} if there are rods or wires.
     *
     * @param force the forces of all effects (N)
     * @throws SimulationException if friction jams, or if rods contradict each other while no particle sticks. If one
     *         sticks, rods that contradict each other are no error: a rule releases it at the end of the motion
     */
    void solve(Block block, double[] state, double time, double[] force) {
        block.take(state, true);
        Optional<String> failure = solve(block, state, force);
        if (failure.isPresent() && !(failure.get().equals(CONTRADICTORY) && !block.held.isEmpty())) {
            throw failure(block, time, failure.get());
        }
    }

    /**
     * Finds the forces of a block, after {@link #prepare}, with given particles held.
     *
     * @return the reason if there are none
     */
    Optional<String> solve(Block block, double[] state, double[] force, IntPredicate isHeld) {
        block.take(state, isHeld, Block.NONE, Block.NONE, Block.ALL);
        return solve(block, state, force);
    }

    /** Counts solutions: the last one is still at hand if the number has not changed. */
    int getSolutions() {
        return solutions;
    }

    /** The residual of the last solution, relative to accelerations. */
    double getLeft() {
        return left;
    }

    /** Finds all forces for the rows taken; returns the reason if there are none. */
    private Optional<String> solve(Block block, double[] state, double[] force) {
        solutions++;
        left = 0;
        if (block.size() == 0) {
            return Optional.empty();
        }
        ContactRows touching = block.touching;
        boolean isIndirect = touching.isFrictionIndirect(state);
        if (isIndirect || !block.isJoined()) {
            Optional<String> failure = solveOnce(block, force);
            if (failure.isPresent()) {
                return failure;
            }
        }
        if (isIndirect) {
            for (int r = 0; r < block.size(); r++) {
                if (!block.isMember(r)) {
                    touching.push[block.contact(r)] = block.force(r);
                }
            }
            addUp(block, force);
        }
        for (int k = 0; k < touching.count; k++) {
            touching.findSlip(k, isIndirect, isIndirect ? total : force, state);
        }
        // friction acts along all surfaces of a particle: it does not change how hard they push a single one
        return block.isJoined() ? solveOnce(block, force) : Optional.empty();
    }

    private Optional<String> solveOnce(Block block, double[] force) {
        putRight(block, force);
        if (!block.solve(Block.NONE, block.hasPairs() || !contacts.isHolding())) {
            return Optional.of("let no contact forces keep all particles out: friction or a moving anchor jams them");
        }
        left = activeSet.getLeft() == 0 ? 0 : activeSet.getLeft() / scale(block, force);
        return left > CONTRADICTION ? Optional.of(CONTRADICTORY) : Optional.empty();
    }

    SimulationException failure(Block block, double time, String reason) {
        int particle = block.particles[0];
        List<String> what = new ArrayList<>();
        if (Arrays.stream(block.members).anyMatch(row -> !rows.isContact(row))) {
            what.add("rods and wires");
        }
        if (block.hasPairs() || block.touching.count > 0) {
            what.add("contacts");
        }
        return new SimulationException(time, particle, "the " + String.join(" and ", what)
                + " connected to particle '" + particles.id(particle) + "' " + reason, null);
    }

    /**
     * b = -(J W F + J' v) - k_s C - k_d C', with C the distance for contacts. Where balls touch, contacts have no
     * feedback: in a dense packing, the errors of many could not decay at the same time.
     */
    private void putRight(Block block, double[] force) {
        if (block.isJoined()) {
            findAccelerations(block, force);
        }
        for (int r = 0; r < block.size(); r++) {
            int row = block.member(r);
            int k = block.contact(r);
            double decay = !block.isJoined() || block.isContact(r) && block.hasPairs() ? 0 : feedback;
            block.right[r] = block.isIdle(r) ? 0 : block.isMember(r)
                    ? -(rows.times(row, accelerations, 3) + rows.bend[row]) - decay * decay * rows.value[row]
                            - 2 * decay * rows.rate[row]
                    : -(block.weight(block.touching.particle[k]) * block.touching.times(k, force, 3) + block.bend(k))
                            - decay * decay * block.touching.value[k] - 2 * decay * block.touching.rate[k];
        }
    }

    /** W F of the particles that are not held. */
    private void findAccelerations(Block block, double[] force) {
        fit(force);
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
    double push(Block block, int r, double[] force) {
        boolean pushes = block.hasPairs() ? block.force(r) > 0 : block.force(r) != 0;
        double rounding = block.hasPairs() ? STILL * scale(block, force) : 0;
        return pushes ? block.force(r) : rounding - block.separation(r);
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
        for (int r = 0; r < block.size(); r++) {
            scale = Math.max(scale, Math.abs(block.right[r]));
        }
        return scale;
    }

    /** Adds the forces found by {@link #solve}. */
    void addForces(Block block, double[] force) {
        block.addForces(force);
        for (int i = block.held.nextSetBit(0); i >= 0; i = block.held.nextSetBit(i + 1)) {
            Arrays.fill(force, STRIDE * i + 3, STRIDE * (i + 1), 0.0);
        }
    }

    /** The power of the friction found by {@link #solve} (W); surfaces at rest do no other work. */
    double frictionPower(Block block, double[] state) {
        double power = 0;
        for (int r = 0; r < block.size(); r++) {
            power -= block.isMember(r) ? 0 : block.force(r) * block.touching.slipTimes(block.contact(r), state);
        }
        return power;
    }

    /** The power with which moving anchors drive the rods found by {@link #solve} (W). */
    double anchorPower(Block block, double[] state) {
        double power = 0;
        for (int r = 0; r < block.size(); r++) {
            power -= block.isMember(r) ? block.force(r) * rows.rateOfAnchors(block.member(r), state,
                    particles.getInverseMasses()) : 0;
        }
        return power;
    }

    /** Sums the forces of effects, rods, wires and contacts, for the particles of a block. */
    double[] addUp(Block block, double[] force) {
        if (total.length != force.length) {
            total = new double[force.length];
        }
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

    BlockImpacts impacts() {
        return new BlockImpacts(system, rows, contacts, this);
    }

    /** Evaluates all rows for another use of a block: the last solution is no longer at hand. */
    void evaluate(double[] state) {
        solutions++;
        rows.evaluate(state);
    }

    /** b = -C, or -C' for velocities. */
    void putRates(Block block, double[] state, int place) {
        for (int r = 0; r < block.size(); r++) {
            block.right[r] = block.isIdle(r) ? 0 : block.isMember(r)
                    ? -(place == 0 ? rows.value : rows.rate)[block.member(r)]
                    : -(place == 0 ? block.touching.value : block.touching.rate)[block.contact(r)];
        }
    }

    /**
     * Stops the velocities of a block that violate its rows; with mayOpen, particles may leave surfaces.
     *
     * @param pairs the pairs of balls in contact that are meant: {@link Block#ALL} or {@link Block#NONE}
     */
    void settle(Block block, double[] state, boolean mayOpen, int pairs) {
        evaluate(state);
        block.take(state, modes::isSticking, Block.NONE, Block.NONE, pairs);
        correctTaken(block, state, 3, mayOpen);
    }

    /**
     * Projects positions or velocities onto rods, wires and touched surfaces. The rows must have been evaluated.
     *
     * @param place 0 for positions, 3 for velocities
     * @param pairs as for {@link #settle}
     */
    void correct(Block block, double[] state, int place, int pairs) {
        solutions++;
        block.take(state, true);
        if (pairs != Block.ALL && block.hasPairs()) {
            block.take(state, modes::isSticking, Block.NONE, Block.NONE, pairs);
        }
        correctTaken(block, state, place, false);
    }

    /** As {@link #correct}, for the rows that were taken. */
    void correctTaken(Block block, double[] state, int place, boolean mayOpen) {
        putRates(block, state, place);
        block.solve(mayOpen ? Block.NONE : Block.ALL, mayOpen);
        block.move(state, place);
    }
}
