package particles.reactions;

import java.util.BitSet;
import particles.law.Particles;
import particles.law.Vector3;
import particles.reactions.ContactModes.Mode;
import particles.reactions.Row.Kind;

/** Impacts of a particle with a surface or another ball, see the {@linkplain particles.reactions theory}. */
public final class BlockImpacts {
    private static final int STRIDE = Particles.STRIDE;
    /** The largest error of speeds after an impact, relative to those before. */
    private static final double CONTRADICTION = 1e-4;
    /** Speeds below this are round-off, relative to those before. */
    private static final double ROUNDING = 1e-12;

    private final RestingContacts contacts;
    private final ContactModes modes;
    private final Blocks blocks;

    BlockImpacts(RestingContacts contacts, Blocks blocks) {
        this.contacts = contacts;
        this.modes = contacts.getModes();
        this.blocks = blocks;
    }

    /**
     * Whether a surface can push a particle away. It cannot where rods and wires keep the particle from moving across
     * the surface, as at the bottom of a wire that touches the ground there: the wire then carries the particle, and
     * the surface exerts no force.
     *
     * @param surface  the surface's index
     * @param particle the particle's index
     * @param state    the state, with the particle on the surface
     * @return true for every particle that is not coupled
     */
    public boolean canPush(int surface, int particle, double[] state) {
        Block block = blocks.of(particle);
        if (!block.isJoined()) {
            return true;
        }
        Row struck = block.takeForImpact(surface, particle, state);
        for (Row row : block.rows) {
            row.right = row == struck ? 1 : 0;
        }
        return block.solve(row -> row != struck, true) && Math.abs(struck.separation) < CONTRADICTION;
    }

    /**
     * Applies an impact: the particle and its whole linkage change velocity by the impulses of rods, wires and other
     * touched surfaces, without friction, but not by those of balls in contact. Sticking particles slide from now on,
     * and lifted ones lose contact.
     *
     * @param surface  the surface's index
     * @param particle the index of a particle that is not in contact with the surface
     * @param leaving  the speed with which it leaves (m/s)
     * @param pull     a velocity whose component into a surface brings a lifted particle back in time (m/s)
     * @param state    the state, in which velocities are changed
     */
    public void strike(int surface, int particle, double leaving, Vector3 pull, double[] state) {
        Block block = blocks.of(particle);
        Row struck = block.takeForImpact(surface, particle, state);
        strike(block, struck, leaving, leaving + Vector3.at(state, STRIDE * particle + 3).norm1(), pull, state);
    }

    /** As {@link BallContacts#strike}. */
    void strikePair(int pair, double leaving, double friction, double[] state) {
        int i = blocks.getRows().get(pair).first;
        int j = blocks.getRows().get(pair).second;
        Block block = blocks.of(blocks.isCoupled(i) ? i : j);
        block.take(state, new BitSet(), pair);
        Row struck = block.find(Kind.BALLS, pair, i).orElseThrow();
        int vi = STRIDE * i + 3;
        int vj = STRIDE * j + 3;
        Vector3 slip = Vector3.at(state, vj).minus(Vector3.at(state, vi));
        strike(block, struck, leaving, leaving + slip.norm1(), Vector3.ZERO, state);
        double impulse = friction * struck.force;
        Vector3 normal = Vector3.at(struck.gradient, 3).normalized();
        slip = slip.minus(normal.times(normal.dot(slip)));
        double mobility = block.weight(i) + block.weight(j);
        double speed = slip.length();
        if (impulse > 0 && speed > 0) {
            Vector3 rub = slip.times(Math.min(impulse / speed, 1 / mobility));
            Vector3.at(state, vi).plus(rub.times(block.weight(i))).put(state, vi);
            Vector3.at(state, vj).minus(rub.times(block.weight(j))).put(state, vj);
            block.take(state, new BitSet(), pair);
            blocks.correctTaken(block, state, 3, true);
        }
    }

    /** Solves for the impulses; speeds are relative to the one given as fast (m/s). */
    private void strike(Block block, Row struck, double leaving, double fast, Vector3 pull, double[] state) {
        blocks.putErrors(block, 3);
        struck.right += leaving;
        if (!block.solve(row -> row != struck, true) || Math.abs(struck.separation) > CONTRADICTION * fast) {
            throw blocks.failure(block, contacts.getSystem().getTime(), "let no impulses keep all particles out");
        }
        block.move(state, 3);
        for (Row row : block.rows) {
            if (row.force != 0) {                       // an impact on one ball leaves the rest of a pile at rest
                modes.setWhereTouching(row.first, Mode.SLIDING);
                modes.setWhereTouching(Math.max(row.first, row.second), Mode.SLIDING);
            } else if (row.kind == Kind.SURFACE && row.separation > Math.max(ROUNDING * fast,
                    Math.max(row.surface.restSpeed(), -Vector3.at(row.gradient, 0).dot(pull)))) {
                modes.set(row.number, row.first, Mode.FREE);
            }
        }
    }
}
