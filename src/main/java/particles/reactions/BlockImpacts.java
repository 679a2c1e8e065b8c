package particles.reactions;

import java.util.Arrays;
import java.util.stream.IntStream;
import particles.ParticleSystem;
import particles.law.Particles;
import particles.law.Vector3;
import particles.reactions.contact.ContactModes;
import particles.reactions.contact.ContactModes.Mode;

/** Impacts of a particle with a surface or another ball, see the {@linkplain particles.reactions theory}. */
final class BlockImpacts {
    private static final int STRIDE = Particles.STRIDE;
    /** The largest error of speeds after an impact, relative to those before. */
    private static final double CONTRADICTION = 1e-4;

    private final ParticleSystem system;
    private final ConstraintRows rows;
    private final RestingContacts contacts;
    private final ContactModes modes;
    private final BlockForces blocks;

    BlockImpacts(ParticleSystem system, ConstraintRows rows, RestingContacts contacts, BlockForces blocks) {
        this.system = system;
        this.rows = rows;
        this.contacts = contacts;
        this.modes = contacts.getModes();
        this.blocks = blocks;
    }

    /** As {@link RestingContacts#canPush}: some impulses of the block move the particle away from the surface. */
    boolean canPush(Block block, int surface, int particle, double[] state) {
        int struck = takeForImpact(block, surface, particle, state);
        Arrays.fill(block.right, 0);
        block.right[struck] = 1;
        return block.solve(struck, true) && Math.abs(block.separation(struck)) < CONTRADICTION;
    }

    /** Returns the row of the impact. */
    private int takeForImpact(Block block, int surface, int particle, double[] state) {
        blocks.evaluate(state);
        block.take(state, i -> false, surface, particle, Block.NONE);
        return block.find(surface, particle);
    }

    /** As {@link RestingContacts#strike}. */
    void strike(Block block, int surface, int particle, double leaving, double[] state) {
        int struck = takeForImpact(block, surface, particle, state);
        strike(block, struck, leaving, leaving + Vector3.at(state, STRIDE * particle + 3).norm1(), state);
    }

    /** As {@link BallContacts#strike}. */
    void strikePair(Block block, int pair, double leaving, double friction, double[] state) {
        int i = rows.first(pair);
        int j = rows.second(pair);
        int struck = takePair(block, pair, state);
        Vector3 slip = Vector3.at(state, STRIDE * j + 3).minus(Vector3.at(state, STRIDE * i + 3));
        strike(block, struck, leaving, leaving + slip.norm1(), state);
        double impulse = friction * block.force(struck);
        Vector3 normal = Vector3.at(rows.gradient, 6 * pair + 3).normalized();
        slip = slip.minus(normal.times(normal.dot(slip)));
        double mobility = block.weight(i) + block.weight(j);
        double speed = slip.length();
        if (impulse > 0 && speed > 0) {
            Vector3 rub = slip.times(Math.min(impulse / speed, 1 / mobility));
            Vector3.at(state, STRIDE * i + 3).plus(rub.times(block.weight(i))).put(state, STRIDE * i + 3);
            Vector3.at(state, STRIDE * j + 3).minus(rub.times(block.weight(j))).put(state, STRIDE * j + 3);
            takePair(block, pair, state);
            blocks.correctTaken(block, state, 3, true);
        }
    }

    /** Takes a block with the row of two balls, and of no others, for an impact; returns that row. */
    private int takePair(Block block, int pair, double[] state) {
        blocks.evaluate(state);
        block.take(state, i -> false, Block.NONE, Block.NONE, pair);
        return IntStream.range(0, block.size()).filter(block::isPair).findFirst().orElseThrow();
    }

    /** Solves for the impulses; speeds are relative to the one given as fast (m/s). */
    private void strike(Block block, int struck, double leaving, double fast, double[] state) {
        blocks.putRates(block, state, 3);
        block.right[struck] += leaving;
        if (!block.solve(struck, true) || Math.abs(block.separation(struck)) > CONTRADICTION * fast) {
            throw blocks.failure(block, system.getTime(), "let no impulses keep all particles out");
        }
        double[] before = state.clone();
        block.move(state, 3);
        for (int i : block.particles) {            // an impact on one ball leaves the rest of a pile at rest
            int v = STRIDE * i + 3;
            if (Vector3.at(state, v).minus(Vector3.at(before, v)).norm1() != 0) {
                modes.setWhereTouching(i, Mode.SLIDING);
            }
        }
        for (int r = 0; r < block.size(); r++) {
            int k = block.contact(r);
            if (r != struck && !block.isMember(r)
                    && block.separation(r) > contacts.getSurfaces().get(block.touching.surface[k]).restSpeed()) {
                modes.set(block.touching.surface[k], block.touching.particle[k], Mode.FREE);
            }
        }
    }
}
