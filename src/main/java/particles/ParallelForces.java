package particles;

import java.util.List;

/**
 * The derivative, evaluated by several threads: each takes a range of the particles, and then some of the blocks of each
 * {@link DivisibleEffect}. What each particle's force is added up from, and in which order, is the same as in one thread,
 * and so are the bits.
 */
final class ParallelForces implements AutoCloseable {
    /** With fewer items one thread is done sooner. Cloths, rk4: two are as fast at 8,000, and take 0.8 of it at 16,000. */
    static final long PAYS_FROM = 16_384;

    private final ForceSum forces;
    private final Particles particles;
    private final List<Effect> effects;
    private final long paysFrom;
    private final Workers workers;
    private double[] state;
    private double time;
    private double[] dSdt;
    private DivisibleEffect divisible;
    private int blocks;
    private final Workers.Work beginning = (part, parts) -> begin(cut(part, parts), cut(part + 1, parts));
    private final Workers.Work middle = this::addBlocks;
    private final Workers.Work end = (part, parts) -> divide(cut(part, parts), cut(part + 1, parts));

    ParallelForces(ForceSum forces, Particles particles, List<Effect> effects, int threads, long paysFrom) {
        this.forces = forces;
        this.particles = particles;
        this.effects = effects;
        this.paysFrom = paysFrom;
        workers = new Workers(threads);
    }

    /** Whether there is enough to do for more than one thread. */
    boolean pays() {
        long items = 0;
        for (int e = 0; e < effects.size(); e++) {
            Effect effect = effects.get(e);
            items += effect.isConcurrent() || effect instanceof DivisibleEffect ? effect.size() : 0;
        }
        return items >= paysFrom;
    }

    void derivative(double[] state, double time, double[] dSdt) {
        this.state = state;
        this.time = time;
        this.dSdt = dSdt;
        if (isConcurrentPerParticle()) {
            workers.run(beginning);
        } else {
            begin(0, particles.count());
        }
        List<Effect> others = forces.others();
        for (int e = 0; e < others.size(); e++) {
            Effect effect = others.get(e);
            if (effect instanceof DivisibleEffect) {
                addDivisible((DivisibleEffect) effect);
            } else {
                effect.addForces(state, time, dSdt, 0, effect.size());
            }
        }
        forces.addReactions(state, time, dSdt);
        workers.run(end);
    }

    private boolean isConcurrentPerParticle() {
        List<Effect> perParticle = forces.perParticle();
        boolean concurrent = true;
        for (int e = 0; e < perParticle.size(); e++) {
            concurrent &= perParticle.get(e).isConcurrent();
        }
        return concurrent;
    }

    private void addDivisible(DivisibleEffect effect) {
        blocks = effect.countBlocks();
        if (blocks > 1) {
            divisible = effect;
            workers.run(middle);
            effect.addForces(state, time, dSdt, effect.getBlockStart(blocks), effect.size());
        } else {
            effect.addForces(state, time, dSdt, 0, effect.size());
        }
    }

    private void addBlocks(int part, int parts) {
        int from = divisible.getBlockStart(blocks * part / parts);
        int to = divisible.getBlockStart(blocks * (part + 1) / parts);
        divisible.addForces(state, time, dSdt, from, to);
    }

    private int cut(int part, int parts) {
        return (int) ((long) particles.count() * part / parts);
    }

    private void begin(int from, int to) {
        forces.begin(state, time, dSdt, from, to);
    }

    private void divide(int from, int to) {
        forces.divideByMasses(dSdt, from, to);
    }

    @Override
    public void close() {
        workers.close();
    }
}
