package particles.reactions;

import java.util.Arrays;
import java.util.BitSet;
import java.util.Optional;
import java.util.function.IntPredicate;
import particles.ParticleSystem;
import particles.law.Particles;
import particles.law.Vector3;
import particles.reactions.contact.ContactModes;

/** Answers questions of rules between steps: how large a normal force is, and whether static friction can hold. */
final class ContactQueries {
    private final ParticleSystem system;
    private final ConstraintRows rows;
    private final RestingContacts contacts;
    private final ContactModes modes;
    private final BlockForces blocks;
    private final BlockForces singles;                  // each particle under a known force
    private final StaticFrictionFeasibility holdSearch;
    private double pushed;                              // sum of the normal forces of the last holdSlack (N)
    private Optional<Block> asked = Optional.empty();   // the last question, of which the rest is kept
    private Optional<String> failure = Optional.empty();
    private Optional<double[]> loads = Optional.empty();
    private double[] askedState = {};
    private double[] askedForce = {};
    private BitSet askedHeld = new BitSet();
    private int askedChanges;
    private int askedSolution;

    ContactQueries(ParticleSystem system, ConstraintRows rows, RestingContacts contacts, BlockForces blocks) {
        this.system = system;
        this.rows = rows;
        this.contacts = contacts;
        this.modes = contacts.getModes();
        this.blocks = blocks;
        singles = new BlockForces(system, rows, contacts, 0);
        holdSearch = new StaticFrictionFeasibility(rows, this);
    }

    /** Finds the forces of a block at rules' request; the last answer is kept, as rules ask for each particle. */
    private void ask(Block block, double[] state, double[] force, IntPredicate isHeld) {
        BitSet held = new BitSet();
        for (int i : block.particles) {
            held.set(i, isHeld.test(i));
        }
        if (asked.isPresent() && asked.get() == block && askedSolution == blocks.getSolutions()
                && askedChanges == modes.getChanges() && askedHeld.equals(held) && Arrays.equals(askedState, state)
                && Arrays.equals(askedForce, force)) {
            return;
        }
        failure = blocks.solve(block, state, force, isHeld);
        loads = Optional.empty();
        asked = Optional.of(block);
        askedSolution = blocks.getSolutions();
        askedChanges = modes.getChanges();
        askedHeld = held;
        askedState = state.clone();
        askedForce = force.clone();
    }

    /** The forces on held particles. Rod forces that are not unique are chosen so that friction holds, if it can. */
    private double[] forcesAtRest(Block block, double[] state, double[] force) {
        if (loads.isEmpty()) {
            loads = Optional.of(blocks.addUp(block, force));
            holdSearch.run(block, state, loads.get());
        }
        return loads.get();
    }

    /** As {@link RestingContacts#pressure}. */
    double pressure(Block block, int surface, int particle, double[] state, double[] force) {
        Block answer = block;
        if (block.isJoined()) {
            blocks.prepare(state, system.getTime());
            ask(block, state, force, modes::isSticking);
            if (failure.isPresent() && block.held.isEmpty()) {
                throw blocks.failure(block, system.getTime(), failure.get());
            }
            if (modes.isSticking(particle)) {
                answer = push(particle, state, forcesAtRest(block, state, force));
            }
        } else {
            answer = push(particle, state, force);
        }
        int r = answer.find(surface, particle);
        double push = r < 0 ? 0 : blocks.push(answer, r, force);
        return r < 0 || push == answer.force(r) ? push : push / answer.weight(particle);
    }

    /** Finds the normal forces on one particle under a known force, without friction. */
    private Block push(int i, double[] state, double[] force) {
        Block alone = singles.single(i);
        alone.take(state, false);
        for (int r = 0; r < alone.size(); r++) {
            int k = alone.contact(r);
            alone.right[r] = -alone.touching.times(k, force, 3) - alone.bend(k);
        }
        alone.solve(Block.NONE, true);
        return alone;
    }

    /** Whether a moving anchor drives a rod, so that friction cannot hold its other end; -1 for any end. */
    private boolean isDriven(Block block, int end, double[] state) {
        for (int row : block.members) {
            if ((end < 0 || rows.first(row) == end || rows.second(row) == end) && rows.isDraggedByAnchor(row, state,
                    blocks.getAccelerations(), system.getParticles().getInverseMasses())) {
                return true;
            }
        }
        return false;
    }

    /** As {@link RestingContacts#holdMargin}. */
    double holdMargin(Block block, int particle, double[] state, double[] force) {
        double[] atRest = force;
        if (block.isJoined()) {
            blocks.prepare(state, system.getTime());
            if (isDriven(block, particle, state)) {
                return -1;
            }
            ask(block, state, force, i -> i == particle || (modes.isSticking(i) || contacts.isSlow(i, state))
                    && !isDriven(block, i, state));
            if (failure.isPresent() || blocks.getLeft() > RestingContacts.ROUNDING && isDriven(block, -1, state)) {
                return -1;                              // the rods' motion keeps it from standing still
            }
            atRest = forcesAtRest(block, state, force);
        }
        double slack = holdSlack(particle, state, atRest);
        return pushed > 0 ? slack : -1;
    }

    /**
     * The largest static friction on a particle minus the force along its surfaces (N): a concave function of the force
     * on it.
     */
    double holdSlack(int i, double[] state, double[] force) {
        Block alone = push(i, state, force);
        Vector3 rest = Vector3.at(force, Particles.STRIDE * i + 3);
        double withstood = 0;
        pushed = 0;
        for (int r = 0; r < alone.size(); r++) {
            int k = alone.contact(r);
            double push = alone.force(r);
            pushed += push;
            withstood += push * alone.touching.friction[k].staticCoefficient();
            rest = rest.plus(Vector3.at(alone.touching.normal, 3 * k).times(push));
        }
        return withstood - Math.sqrt(rest.dot(rest));
    }
}
