package particles.engine;

import java.util.Optional;
import java.util.concurrent.ForkJoinTask;
import java.util.function.IntConsumer;
import java.util.stream.IntStream;
import particles.law.DivisibleEffect;
import particles.law.Effect;
import particles.law.Particles;

/**
 * Evaluates the derivative on several threads: each takes a range of the particles and some of the blocks of each
 * {@link DivisibleEffect}. Each particle's force is summed in the same order as on one thread, so the bits are the
 * same.
 */
public final class ParallelForces implements ForceSum.Parallel {
    /** With fewer forces one thread is faster: on cloths with rk4, two are only as fast at half this number. */
    public static final long PAYS_FROM = 16_384;

    private final ForceSum forces;
    private final Particles particles;
    private final long paysFrom;
    private final int threads;
    private final Runnable[] parts;                     // all but the caller's
    private final ForkJoinTask<?>[] begun;
    private double[] state;
    private double time;
    private double[] dSdt;
    private DivisibleEffect divisible;
    private int blocks;
    private final IntConsumer beginning = this::beginRange;
    private final IntConsumer middle = this::addBlocks;
    private final IntConsumer end = this::finishRange;
    private IntConsumer work;                           // one of these
    private volatile Throwable failure;

    private ParallelForces(ForceSum forces, int threads, long paysFrom) {
        this.forces = forces;
        particles = forces.getParticles();
        this.paysFrom = paysFrom;
        this.threads = threads;
        parts = IntStream.range(1, threads).mapToObj(part -> (Runnable) () -> runPart(part)).toArray(Runnable[]::new);
        begun = new ForkJoinTask<?>[parts.length];
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
        long items = (long) forces.getPerParticle().length * particles.count();
        for (Effect other : forces.getOthers()) {
            items += other instanceof DivisibleEffect effect ? effect.size() : 0;
        }
        return items >= paysFrom;
    }

    @Override
    public void derivative(double[] state, double time, double[] dSdt) {
        this.state = state;
        this.time = time;
        this.dSdt = dSdt;
        run(beginning);
        for (Effect effect : forces.getOthers()) {
            if (effect instanceof DivisibleEffect parts && isDivided(parts)) {
                run(middle);
                divisible.addPart(blocks, state, time, dSdt);
            } else {
                effect.addForces(state, time, dSdt);
            }
        }
        forces.addReactions(state, time, dSdt);
        run(end);
    }

    /**
     * Runs all parts, part 0 in this thread, which also runs those that no other thread of the common pool has begun.
     * An exception of any part is thrown, as it is, when all have ended. Each time the parts are new tasks, of 24
     * bytes each: a thread marks a task as done before it wakes those who wait. If the task has begun again by then,
     * this late signal takes the caller off the list of those who wait, and the caller waits for ever.
     */
    private void run(IntConsumer task) {
        work = task;
        failure = null;
        for (int p = 0; p < parts.length; p++) {
            begun[p] = ForkJoinTask.adapt(parts[p]).fork();
        }
        runPart(0);
        for (int p = parts.length - 1; p >= 0; p--) {
            begun[p].join();
        }
        if (failure instanceof Error error) {
            throw error;
        } else if (failure != null) {
            throw (RuntimeException) failure;
        }
    }

    private void runPart(int part) {
        try {
            work.accept(part);
        } catch (RuntimeException | Error e) {      // a joined task would throw a copy, without its message at times
            failure = e;
        }
    }

    /** Makes the effect the one whose blocks are evaluated next; returns false if it has only one. */
    private boolean isDivided(DivisibleEffect effect) {
        divisible = effect;
        divisible.prepare(state);
        blocks = divisible.countBlocks();
        return blocks > 1;
    }

    private void beginRange(int part) {
        int n = particles.count();
        forces.begin(state, time, dSdt, cut(n, part), cut(n, part + 1));
    }

    private void addBlocks(int part) {
        for (int block = cut(blocks, part); block < cut(blocks, part + 1); block++) {
            divisible.addPart(block, state, time, dSdt);
        }
    }

    private void finishRange(int part) {
        int n = particles.count();
        forces.finish(dSdt, cut(n, part), cut(n, part + 1));
    }

    /** The first item of a part. */
    private int cut(int all, int part) {
        return (int) ((long) all * part / threads);
    }
}
