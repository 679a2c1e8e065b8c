package particles.reactions;

import java.nio.DoubleBuffer;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import java.util.function.IntPredicate;
import particles.ParticleSystem;
import particles.law.Particles;
import particles.law.Scales.Skin;
import particles.law.Vector3;
import particles.reactions.Row.Kind;

/** Answers questions of rules between steps: how large a normal force is, and whether static friction can hold. */
public final class ContactQueries {
    private final ParticleSystem system;
    private final RestingContacts contacts;
    private final ContactModes modes;
    private final Blocks blocks;
    private final Blocks singles;                       // each particle under a known force
    private List<?> asked = List.of();                  // the last question, of which the rest is kept
    private Optional<String> failure = Optional.empty();
    private Optional<StaticFriction> atRest = Optional.empty();

    ContactQueries(RestingContacts contacts, Blocks blocks) {
        system = contacts.getSystem();
        this.contacts = contacts;
        this.modes = contacts.getModes();
        this.blocks = blocks;
        singles = new Blocks(system, new Rows(), 0, contacts, i -> false);
    }

    /** Finds the forces of a block at rules' request; the last answer is kept, as rules ask for each particle. */
    private void ask(Block block, double[] state, double[] force, IntPredicate isHeld) {
        BitSet held = block.where(isHeld);
        if (!asked.equals(question(block, held, state, force))) {
            block.take(state, held, Block.ALL);
            failure = blocks.solve(block, state, force);
            atRest = Optional.empty();
            asked = question(block, held, state.clone(), force.clone());
        }
    }

    private List<?> question(Block block, BitSet held, double[] state, double[] force) {
        return List.of(block, held, blocks.getSolutions(), modes.getChanges(), DoubleBuffer.wrap(state),
                DoubleBuffer.wrap(force));
    }

    /** The forces on the held particles of a block in the last question. */
    private StaticFriction forcesAtRest(Block block, double[] state, double[] force) {
        if (atRest.isEmpty()) {
            atRest = Optional.of(new StaticFriction(this, block, state, blocks.addUp(block, force)));
        }
        return atRest.get();
    }

    /**
     * The normal force of a surface on a particle that touches it.
     *
     * @param surface  the surface's index
     * @param particle the particle's index
     * @param state    the particles' state
     * @param force    the total force of all effects (N)
     * @return the normal force (N); if it is 0, minus the force that pulls the particle off
     */
    public double pressure(int surface, int particle, double[] state, double[] force) {
        if (modes.only(particle) == surface && !blocks.isCoupled(particle)) {
            return pushAlone(surface, particle, state, force);
        }
        Block block = blocks.of(particle);
        if (block.isJoined()) {
            blocks.prepare(state, system.getTime());
            ask(block, state, force, modes::isSticking);
            if (failure.isPresent() && block.held.isEmpty()) {
                throw block.failure(system.getTime(), failure.get());
            }
        }
        if (!block.isJoined() || modes.isSticking(particle)) {
            block = push(particle, state, block.isJoined() ? forcesAtRest(block, state, force).getForces() : force);
        }
        Optional<Row> row = Row.find(block.rows, Kind.SURFACE, surface, particle);
        double push = row.isEmpty() ? 0 : blocks.push(block, row.get(), force);
        return row.isEmpty() || push == row.get().force ? push : push / block.weight(particle);
    }

    private double pushAlone(int surface, int i, double[] state, double[] force) {
        ContactSurface only = contacts.getSurfaces().get(surface);
        return SlidingFriction.push(only.normal(state, i), i, system.getParticles().mass(i), only, state, force);
    }

    /** Finds the normal forces on one particle under a known force, without friction. */
    Block push(int i, double[] state, double[] force) {
        Block alone = singles.of(i);
        alone.take(state, Block.ALL);
        for (Row row : alone.rows) {
            row.right = -(row.times(force, 3) + row.bend);
        }
        alone.solve(row -> true, true);
        return alone;
    }

    /** The rows of a block that act on no other particles than these, which may all move, without their contacts. */
    Block linksBetween(Block block, int[] held) {
        RestingContacts none = new RestingContacts(system, List.of());
        int[] between = Arrays.stream(block.rows).filter(Row::isIdle).mapToInt(row -> row.number).toArray();
        return new Blocks(system, blocks.getRows(), 0, none, i -> false).block(between, held);
    }

    /** Whether a moving anchor drives a rod, so that friction cannot hold its other end; -1 for any end. */
    private boolean isDriven(Block block, int end, double[] state) {
        boolean driven = false;
        for (int r : block.members) {
            Row row = blocks.getRows().get(r);
            driven |= (end < 0 || row.first == end || row.second == end) && row.isDraggedByAnchor(state,
                    blocks.getAccelerations(), system.getParticles().getInverseMasses());
        }
        return driven;
    }

    /**
     * The margin by which static friction can hold a particle.
     *
     * @param particle its index
     * @param state    the particles' state
     * @param force    the total force of all effects (N)
     * @return the largest static friction minus the tangential force (N); negative if friction cannot hold it, or if
     *         nothing presses on it and no forces of rods and balls balance all others
     */
    public double holdMargin(int particle, double[] state, double[] force) {
        if (!blocks.isCoupled(particle)) {
            return marginAlone(particle, state, force);
        }
        Block block = blocks.of(particle);
        blocks.prepare(state, system.getTime());
        if (isDriven(block, particle, state)) {
            return -1;
        }
        ask(block, state, force, i -> i == particle || (modes.isSticking(i) || contacts.isSlow(i, state))
                && !isDriven(block, i, state));
        boolean moves = failure.isPresent()             // the rods' motion keeps it from standing still
                || blocks.getLeft() > Tolerances.STANDSTILL && isDriven(block, -1, state);
        return moves ? -1 : forcesAtRest(block, state, force).margin(particle);
    }

    /** The skin of a particle on one surface. */
    Skin skin(int i, double[] state, Vector3 normal) {
        return contacts.getSliding().skin(i, state, normal);
    }

    /** The margin of a particle under a known force: of its contacts' static friction over the force along them (N). */
    double marginAlone(int i, double[] state, double[] force) {
        int only = modes.only(i);
        if (only >= 0) {
            double push = pushAlone(only, i, state, force);
            Vector3 normal = contacts.getSurfaces().get(only).normal(state, i);
            Vector3 left = Vector3.at(force, Particles.STRIDE * i + 3).plus(normal.times(push));
            return push > 0 ? push * contacts.getSurfaces().get(only).friction().staticCoefficient()
                    - skin(i, state, normal).toHold(left) : -1;
        }
        Block alone = push(i, state, force);
        Vector3 rest = Vector3.at(force, Particles.STRIDE * i + 3);
        double withstood = 0;
        double pushed = 0;
        for (Row row : alone.rows) {
            pushed += row.force;
            withstood += row.force * row.surface.friction().staticCoefficient();
            rest = rest.plus(Vector3.at(row.gradient, 0).times(row.force));
        }
        return pushed > 0 ? withstood - contacts.getSliding().skin(i, state, alone.rows).toHold(rest) : -1;
    }

    /**
     * How long sliding friction takes to stop a particle that is not coupled.
     *
     * @param state the particles' state
     * @param force the total force of all effects (N)
     * @return the time (s); infinite if it does not slow down
     */
    public double stoppingTime(int i, double[] state, double[] force) {
        Vector3 velocity = Vector3.at(state, Particles.STRIDE * i + 3);
        double speed = velocity.length();
        if (speed == 0) {
            return Double.POSITIVE_INFINITY;
        }
        double slowing = -Vector3.at(force, Particles.STRIDE * i + 3).dot(velocity) / speed;
        int only = modes.only(i);
        if (only >= 0) {
            ContactSurface surface = contacts.getSurfaces().get(only);
            slowing += surface.friction().ofCoulomb(pushAlone(only, i, state, force))
                    * (skin(i, state, surface.normal(state, i)).stretch(velocity).length() / speed);
        } else {
            Block alone = push(i, state, force);
            double factor = contacts.getSliding().skin(i, state, alone.rows).stretch(velocity).length() / speed;
            for (Row row : alone.rows) {
                slowing += factor * row.surface.friction().ofCoulomb(row.force);
            }
        }
        return slowing > 0 ? system.getParticles().mass(i) * speed / slowing : Double.POSITIVE_INFINITY;
    }
}
