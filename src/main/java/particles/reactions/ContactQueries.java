package particles.reactions;

import java.nio.DoubleBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import particles.ParticleSystem;
import particles.law.Particles;
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
            atRest = Optional.of(new StaticFriction(block, state, blocks.addUp(block, force)));
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
        Block block = blocks.of(particle);
        if (block.isJoined()) {
            blocks.prepare(state, system.getTime());
            ask(block, state, force, modes::isSticking);
            if (failure.isPresent() && block.held.isEmpty()) {
                throw blocks.failure(block, system.getTime(), failure.get());
            }
        }
        if (!block.isJoined() || modes.isSticking(particle)) {
            block = push(particle, state, block.isJoined() ? forcesAtRest(block, state, force).getForces() : force);
        }
        Optional<Row> row = block.find(Kind.SURFACE, surface, particle);
        double push = row.isEmpty() ? 0 : blocks.push(block, row.get(), force);
        return row.isEmpty() || push == row.get().force ? push : push / block.weight(particle);
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
        Block block = blocks.of(particle);
        if (!block.isJoined()) {
            return marginAlone(particle, state, force);
        }
        blocks.prepare(state, system.getTime());
        if (isDriven(block, particle, state)) {
            return -1;
        }
        ask(block, state, force, i -> i == particle || (modes.isSticking(i) || contacts.isSlow(i, state))
                && !isDriven(block, i, state));
        boolean moves = failure.isPresent()             // the rods' motion keeps it from standing still
                || blocks.getLeft() > RestingContacts.ROUNDING && isDriven(block, -1, state);
        return moves ? -1 : forcesAtRest(block, state, force).margin(particle);
    }

    /** The margin of a particle under a known force: of its contacts' static friction over the force along them (N). */
    double marginAlone(int i, double[] state, double[] force) {
        Block alone = push(i, state, force);
        Vector3 rest = Vector3.at(force, Particles.STRIDE * i + 3);
        double withstood = 0;
        double pushed = 0;
        for (Row row : alone.rows) {
            pushed += row.force;
            withstood += row.force * row.surface.friction().staticCoefficient();
            rest = rest.plus(Vector3.at(row.gradient, 0).times(row.force));
        }
        return pushed > 0 ? withstood - Math.sqrt(rest.dot(rest)) : -1;
    }

    /**
     * Decides whether static friction can hold the particles of a linkage that is statically indeterminate. The loads
     * of rods and balls between held particles are not unique, but the motion does not depend on them: friction holds
     * if some loads and some contact forces in the friction cones balance all forces. They are found in turns: each
     * contact force becomes the one that leaves the smallest force on its particle, then all loads together become
     * those that leave the smallest accelerations, as if nothing touched a surface. As all sets of allowed forces are
     * convex, what is left over falls to 0, or to the least possible; what then still moves is not held. (Alternating
     * minimisation; compare M. Jean, "The non-smooth contact dynamics method", 1999.)
     */
    private final class StaticFriction {
        private static final int MOST_SWEEPS = 1_000;
        /** What may be left of the force on a particle, relative to all forces on it. */
        private static final double ENOUGH = 1e-6;
        /**
         * The search ends when what is left on each particle changes by less than this fraction of it, or is enough.
         */
        private static final double PROGRESS = 1e-5;

        private final Block block;
        private final double[] state;
        private final double[] total;
        private final double[] balanced;                    // the forces without loads, balanced by the cones
        private final double[] left;                        // the same with loads
        private double size;                                // of all forces; 0 if no search was needed

        /** The contact force of a particle on a surface; all forces begin at an index. */
        private record Cone(int place, Vector3 normal, double friction, double[] force) {
            /** Balances what is left of the force on its particle, as far as it can. */
            void balance(double[] left, double[] balanced) {
                Vector3 before = Vector3.at(force, 0);
                Vector3 now = nearest(before.minus(Vector3.at(left, place)));
                now.put(force, 0);
                for (double[] sum : new double[][] {left, balanced}) {
                    Vector3.at(sum, place).minus(before).plus(now).put(sum, place);
                }
            }

            private Vector3 nearest(Vector3 wanted) {
                double push = normal.dot(wanted);
                Vector3 across = wanted.minus(normal.times(push));
                double size = across.length();
                if (size <= friction * push) {
                    return wanted;
                }
                double most = Math.max(0, (push + friction * size) / (1 + friction * friction));
                return normal.plus(across.times(size == 0 ? 0 : friction / size)).times(most);
            }
        }

        /**
         * @param block the rods and wires of particles that cannot move
         * @param total the forces without these loads (N), to which they are added
         */
        StaticFriction(Block block, double[] state, double[] total) {
            this.block = block;
            this.state = state;
            this.total = total;
            balanced = total.clone();
            left = total.clone();
            if (!held().allMatch(i -> marginAlone(i, state, total) > 0)) {
                search();
            }
        }

        private IntStream held() {
            return Arrays.stream(block.particles).filter(block.held::get);
        }

        private void search() {
            List<Cone> cones = new ArrayList<>();
            held().forEach(i -> {
                size += Vector3.at(total, place(i)).norm1();
                for (Row row : push(i, state, total).rows) {
                    cones.add(new Cone(place(i), Vector3.at(row.gradient, 0),
                            row.surface.friction().staticCoefficient(), new double[3]));
                }
            });
            Block links = linksBetween(block, held().toArray());
            links.take(state, Block.ALL);
            double[] before = left.clone();
            for (int sweep = 0; sweep < MOST_SWEEPS; sweep++) {
                cones.forEach(cone -> cone.balance(left, balanced));
                putLoads(links);
                if (held().noneMatch(i -> margin(i) < allowed(i) / 2 && hasChanged(i, before))) {
                    break;
                }
                System.arraycopy(left, 0, before, 0, left.length);
            }
            links.addForces(total);
        }

        /** Whether what is left of the force on a particle still changes from sweep to sweep. */
        private boolean hasChanged(int i, double[] before) {
            Vector3 now = Vector3.at(left, place(i));
            return now.minus(Vector3.at(before, place(i))).length() > PROGRESS * now.length();
        }

        /**
         * Finds the loads that leave the smallest accelerations of held particles, J W (F + J<sup>T</sup> load) = 0.
         */
        private void putLoads(Block links) {
            System.arraycopy(balanced, 0, left, 0, left.length);
            for (Row row : links.rows) {
                row.right = 0;
                for (int k = 0; k < 2; k++) {
                    int i = row.particle(k);
                    if (i >= 0 && block.held.get(i)) {
                        row.right -= block.weight(i) * Row.dot(row.gradient, 3 * k, left, place(i));
                    }
                }
            }
            links.solve(row -> true, true);
            links.addForces(left);
        }

        private static int place(int particle) {
            return Particles.STRIDE * particle + 3;
        }

        /** The forces with these loads (N). */
        double[] getForces() {
            return total;
        }

        /**
         * As {@link ContactQueries#holdMargin}; after a search, what may be left of the force less what is. Forces that
         * others balance hold a particle even if nothing presses it on.
         */
        double margin(int particle) {
            return size == 0 ? marginAlone(particle, state, total)
                    : allowed(particle) - Vector3.at(left, place(particle)).length();
        }

        private double allowed(int particle) {
            Vector3 given = Vector3.at(total, place(particle));
            Vector3 withCones = Vector3.at(balanced, place(particle));
            Vector3 loads = Vector3.at(left, place(particle)).minus(withCones);
            return ENOUGH * (given.norm1() + withCones.minus(given).norm1() + loads.norm1());
        }
    }
}
