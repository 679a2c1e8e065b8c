package particles.engine;

import java.util.Optional;
import java.util.function.IntConsumer;
import particles.law.DivisibleEffect;
import particles.law.Effect;
import particles.law.Particles;

/**
 * Evaluates the derivative on several threads: they share out ranges of the particles and the blocks of each
 * {@link DivisibleEffect}. Each particle's force is summed in the same order as on one thread, so the bits are the
 * same.
 *
 * <p>On a machine that is busy with other work, another thread may be kept waiting in the middle of its piece, and the
 * caller with it. After each such delay, one thread evaluates alone for {@value #ALONE} times as long as it lasted.
 */
public final class ParallelForces implements ForceSum.Parallel {
    /** With fewer forces one thread is faster: on cloths with rk4, two are only as fast at half this number. */
    public static final long PAYS_FROM = 16_384;
    /** More pieces even out the load, but threads then touch more of each other's memory. */
    private static final int MOST_PIECES = 16;
    private static final int ALONE = 20;

    private final ForceSum forces;
    private final Particles particles;
    private final long paysFrom;
    private final SharedWork shared;
    private long aloneUntil = System.nanoTime();
    private double[] state;
    private double time;
    private double factor;
    private double[] dSdt;
    private DivisibleEffect divisible;
    private int items;                                  // particles or blocks to be shared out, in pieces
    private int pieces;
    private final IntConsumer beginning = this::beginPiece;
    private final IntConsumer middle = this::addPiece;
    private final IntConsumer end = this::finishPiece;

    private ParallelForces(ForceSum forces, int threads, long paysFrom) {
        this.forces = forces;
        particles = forces.getParticles();
        this.paysFrom = paysFrom;
        shared = new SharedWork(threads - 1);
    }

    /**
     * Lets several threads evaluate the forces of a system if it has enough of them.
     *
     * @param forces  the system's forces
     * @param threads the number of threads, including the caller's
     */
    public static void use(ForceSum forces, int threads) {
        use(forces, threads, PAYS_FROM);
    }

    /** As above, with another number of forces from which threads are used. */
    public static void use(ForceSum forces, int threads, long paysFrom) {
        if (threads < 1) {
            throw new IllegalArgumentException("forces cannot be evaluated by " + threads + " threads");
        }
        forces.setParallel(threads == 1 ? Optional.empty()
                : Optional.of(new ParallelForces(forces, threads, paysFrom)));
    }

    @Override
    public boolean pays() {
        if (System.nanoTime() - aloneUntil < 0) {
            return false;
        }
        long items = (long) forces.getPerParticle().length * particles.count();
        for (Effect other : forces.getOthers()) {
            items += other instanceof DivisibleEffect effect ? effect.size() : 0;
        }
        return items >= paysFrom;
    }

    @Override
    public void derivative(double[] state, double time, double factor, double[] dSdt) {
        this.state = state;
        this.time = time;
        this.factor = factor;
        this.dSdt = dSdt;
        shared.begin();
        share(particles.count(), beginning);
        for (Effect effect : forces.getOthers()) {
            if (effect instanceof DivisibleEffect parts && isDivided(parts)) {
                int blocks = divisible.countBlocks();
                share(blocks, middle);
                divisible.addPart(blocks, state, time, dSdt);
            } else {
                effect.addForces(state, time, dSdt);
            }
        }
        forces.addReactions(state, time, dSdt);
        share(particles.count(), end);
        aloneUntil = System.nanoTime() + ALONE * shared.getDelay();
    }

    /** Makes the effect the one whose blocks are evaluated next; returns false if it has only one. */
    private boolean isDivided(DivisibleEffect effect) {
        divisible = effect;
        divisible.prepare(state);
        return divisible.countBlocks() > 1;
    }

    private void share(int items, IntConsumer work) {
        this.items = items;
        pieces = Math.min(items, MOST_PIECES);
        shared.run(pieces, work);
    }

    private void beginPiece(int piece) {
        forces.begin(state, time, factor, dSdt, cut(piece), cut(piece + 1));
    }

    private void addPiece(int piece) {
        for (int block = cut(piece); block < cut(piece + 1); block++) {
            divisible.addPart(block, state, time, dSdt);
        }
    }

    private void finishPiece(int piece) {
        forces.finish(factor, dSdt, cut(piece), cut(piece + 1));
    }

    /** The first item of a piece. */
    private int cut(int piece) {
        return (int) ((long) items * piece / pieces);
    }
}
