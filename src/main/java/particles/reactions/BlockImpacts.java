package particles.reactions;

import java.util.Arrays;
import particles.ParticleSystem;
import particles.law.Particles;
import particles.law.Vector3;
import particles.reactions.Rows.Kind;
import particles.reactions.contact.ContactModes;
import particles.reactions.contact.ContactModes.Mode;

/** Impacts of a particle with a surface or another ball, see the {@linkplain particles.reactions theory}. */
final class BlockImpacts {
    private static final int STRIDE = Particles.STRIDE;
    /** The largest error of speeds after an impact, relative to those before. */
    private static final double CONTRADICTION = 1e-4;

    private final ParticleSystem system;
    private final RestingContacts contacts;
    private final ContactModes modes;
    private final Blocks blocks;

    BlockImpacts(ParticleSystem system, RestingContacts contacts, Blocks blocks) {
        this.system = system;
        this.contacts = contacts;
        this.modes = contacts.getModes();
        this.blocks = blocks;
    }

    /** As {@link RestingContacts#canPush}: some impulses of the block move the particle away from the surface. */
    boolean canPush(int surface, int particle, double[] state) {
        Block block = blocks.of(particle);
        Mode before = modes.get(surface, particle);
        int struck = takeForImpact(block, surface, particle, state);
        modes.set(surface, particle, before);
        Arrays.fill(block.right, 0);
        block.right[struck] = 1;
        return block.solve(struck, true) && Math.abs(block.separation(struck)) < CONTRADICTION;
    }

    /** Takes a block with the row of an impact, which is returned. */
    private int takeForImpact(Block block, int surface, int particle, double[] state) {
        modes.set(surface, particle, Mode.SLIDING);
        block.take(state, i -> false, Block.NONE);
        return block.find(Kind.SURFACE, surface, particle);
    }

    /** As {@link RestingContacts#strike}. */
    void strike(int surface, int particle, double leaving, double[] state) {
        Block block = blocks.of(particle);
        Mode before = modes.get(surface, particle);
        int struck = takeForImpact(block, surface, particle, state);
        strike(block, struck, leaving, leaving + Vector3.at(state, STRIDE * particle + 3).norm1(), state);
        if (before == Mode.FREE) {
            modes.set(surface, particle, before);
        }
    }

    /** As {@link BallContacts#strike}. */
    void strikePair(int pair, double leaving, double friction, double[] state) {
        int i = blocks.getRows().first[pair];
        int j = blocks.getRows().second[pair];
        Block block = blocks.of(blocks.isCoupled(i) ? i : j);
        block.take(state, particle -> false, pair);
        int struck = block.find(Kind.BALLS, pair, i);
        Vector3 slip = Vector3.at(state, STRIDE * j + 3).minus(Vector3.at(state, STRIDE * i + 3));
        strike(block, struck, leaving, leaving + slip.norm1(), state);
        double impulse = friction * block.force(struck);
        Vector3 normal = Vector3.at(block.rows.gradient, 6 * struck + 3).normalized();
        slip = slip.minus(normal.times(normal.dot(slip)));
        double mobility = block.weight(i) + block.weight(j);
        double speed = slip.length();
        if (impulse > 0 && speed > 0) {
            Vector3 rub = slip.times(Math.min(impulse / speed, 1 / mobility));
            Vector3.at(state, STRIDE * i + 3).plus(rub.times(block.weight(i))).put(state, STRIDE * i + 3);
            Vector3.at(state, STRIDE * j + 3).minus(rub.times(block.weight(j))).put(state, STRIDE * j + 3);
            block.take(state, particle -> false, pair);
            blocks.correctTaken(block, state, 3, true);
        }
    }

    /** Solves for the impulses; speeds are relative to the one given as fast (m/s). */
    private void strike(Block block, int struck, double leaving, double fast, double[] state) {
        blocks.putErrors(block, 3);
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
        for (int r = 0; r < block.rows.count; r++) {
            int p = block.rows.number[r];
            if (r != struck && block.rows.kind[r] == Kind.SURFACE
                    && block.separation(r) > contacts.getSurfaces().get(p).restSpeed()) {
                modes.set(p, block.rows.first[r], Mode.FREE);
            }
        }
    }
}
