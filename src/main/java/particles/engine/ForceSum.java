package particles.engine;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import particles.law.Effect;
import particles.law.Particles;
import particles.law.PerParticleEffect;
import particles.law.Reaction;

/** Computes the total force of all effects and reactions, and the derivative (v, F/m). */
public final class ForceSum {
    private static final int STRIDE = Particles.STRIDE;
    /** Particles are evaluated in groups of this size: their state and force, 48 kB, stay in the cache. */
    private static final int STRETCH = 512;

    private final Particles particles;
    private final List<Effect> effects;
    private final List<Reaction> reactions;
    private Optional<ParallelDerivative> parallel = Optional.empty();
    /** Setting the derivative to (v, 0) comes before the effects that act on each particle separately. */
    private final List<PerParticleEffect> passes = new ArrayList<>(List.of(new NoForce()));
    private final List<PerParticleEffect> perParticle = new ArrayList<>();
    private final List<Effect> others = new ArrayList<>();
    private int sorted;                                 // how many effects are in the two lists

    /**
     * Sets a range of the derivative to (v, 0). As an effect among effects it makes the call in {@link #begin} one of
     * three or more kinds, so that Java compiles each loop by itself: in one nest they take 1.5 times as long.
     */
    private static final class NoForce implements PerParticleEffect {
        @Override
        public String getName() {
            return "no force";
        }

        @Override
        public void addForces(double[] state, double time, double[] dSdt, int from, int to) {
            int first = STRIDE * from;
            System.arraycopy(state, first + 3, dSdt, first, STRIDE * (to - from) - 3);
            for (int v = first + 3; v < STRIDE * to; v += STRIDE) {
                dSdt[v] = 0;
                dSdt[v + 1] = 0;
                dSdt[v + 2] = 0;
            }
        }
    }

    /** Keeps the lists, which may grow later. */
    public ForceSum(Particles particles, List<Effect> effects, List<Reaction> reactions) {
        this.particles = particles;
        this.effects = effects;
        this.reactions = reactions;
    }

    /** Computes the derivative (v, F/m) of a state. */
    public void derivative(double[] state, double time, double[] dSdt) {
        sortEffects();
        if (parallel.isPresent() && parallel.get().pays()) {
            parallel.get().derivative(state, time, dSdt);
            return;
        }
        int n = particles.count();
        begin(state, time, dSdt, 0, n);
        for (int e = 0; e < others.size(); e++) {
            others.get(e).addForces(state, time, dSdt);
        }
        addReactions(state, time, dSdt);
        finish(dSdt, 0, n);
    }

    /** The effects that act on each particle separately. */
    public List<PerParticleEffect> getPerParticle() {
        return perParticle;
    }

    /** All other effects, in the order of evaluation. */
    public List<Effect> getOthers() {
        return others;
    }

    /** Sets a parallel evaluation, used when it pays; closes the previous one. */
    public void setParallel(Optional<ParallelDerivative> other) {
        parallel.ifPresent(ParallelDerivative::close);
        parallel = other;
    }

    private void sortEffects() {
        for (; sorted < effects.size(); sorted++) {
            if (effects.get(sorted) instanceof PerParticleEffect effect) {
                perParticle.add(effect);
                passes.add(effect);
            } else {
                others.add(effects.get(sorted));
            }
        }
    }

    /** Computes (v, F) of the particles first ... end - 1, with the forces of the per-particle effects. */
    public void begin(double[] state, double time, double[] dSdt, int first, int end) {
        for (int from = first; from < end; from += STRETCH) {
            int to = Math.min(end, from + STRETCH);
            for (int e = 0; e < passes.size(); e++) {
                passes.get(e).addForces(state, time, dSdt, from, to);
            }
        }
    }

    /** Turns (v, F) into the derivative (v, F/m). */
    public void finish(double[] dSdt, int from, int to) {
        double[] inverseMasses = particles.getInverseMasses();
        for (int v = STRIDE * from + 3, i = from; v < STRIDE * to; v += STRIDE, i++) {
            double inverseMass = inverseMasses[i];
            dSdt[v] *= inverseMass;
            dSdt[v + 1] *= inverseMass;
            dSdt[v + 2] *= inverseMass;
        }
    }

    /** Computes the forces of all effects, with 0 in the entries of positions. */
    public void effects(double[] state, double time, double[] force) {
        int n = particles.count();
        Arrays.fill(force, 0, STRIDE * n, 0.0);
        for (int e = 0; e < effects.size(); e++) {
            effects.get(e).addForces(state, time, force);
        }
    }

    /** @return whether any effect or reaction depends on velocities */
    public boolean dependOnVelocity() {
        boolean depend = false;
        for (int e = 0; e < effects.size(); e++) {
            depend |= effects.get(e).dependsOnVelocity();
        }
        for (int r = 0; r < reactions.size(); r++) {
            depend |= reactions.get(r).dependsOnVelocity();
        }
        return depend;
    }

    /** Adds the forces of all active reactions. */
    public void addReactions(double[] state, double time, double[] force) {
        for (int r = 0; r < reactions.size(); r++) {
            Reaction reaction = reactions.get(r);
            if (reaction.isActive()) {
                reaction.addForces(state, time, force);
            }
        }
    }
}
