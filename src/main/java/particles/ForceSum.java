package particles;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/** Adds up what effects and reactions do. */
final class ForceSum {
    private static final int STRIDE = Particles.STRIDE;
    /** Particles at a time: state and force of so many, 48 kB together, stay in the processor's nearest memory. */
    private static final int STRETCH = 512;

    private final Particles particles;
    private final List<Effect> effects;
    private final List<Reaction> reactions;
    private Optional<ParallelForces> parallel = Optional.empty();
    private LinearLaw linear = LinearLaw.NONE;          // of all effects that have one
    private final List<Effect> perParticle = new ArrayList<>();     // those that have none
    private final List<Effect> others = new ArrayList<>();
    private int sorted;                                 // how many effects the three above were made of

    ForceSum(Particles particles, List<Effect> effects, List<Reaction> reactions) {
        this.particles = particles;
        this.effects = effects;
        this.reactions = reactions;
    }

    /** The derivative (v, F/m) of a state. */
    void derivative(double[] state, double time, double[] dSdt) {
        if (sorted < effects.size()) {
            sortEffects();
        }
        if (parallel.isPresent() && parallel.get().pays()) {
            parallel.get().derivative(state, time, dSdt);
            return;
        }
        int n = particles.count();
        begin(state, time, dSdt, 0, n);
        for (int e = 0; e < others.size(); e++) {
            Effect effect = others.get(e);
            effect.addForces(state, time, dSdt, 0, effect.size());
        }
        addReactions(state, time, dSdt);
        divideByMasses(dSdt, 0, n);
    }

    /** The effects that are evaluated particle by particle; those with a linear law are not among them. */
    List<Effect> perParticle() {
        return perParticle;
    }

    /** The effects that are neither evaluated particle by particle nor by their linear law, in the order in which they act. */
    List<Effect> others() {
        return others;
    }

    /** Sets how many threads evaluate systems of so many items or more; those there were before end. */
    void setThreads(int threads, long paysFrom) {
        if (threads < 1) {
            throw new IllegalArgumentException("forces cannot be evaluated by " + threads + " threads");
        }
        parallel.ifPresent(ParallelForces::close);
        parallel = threads == 1 ? Optional.empty()
                : Optional.of(new ParallelForces(this, particles, effects, threads, paysFrom));
    }

    /** Effects are added and never taken out, and of what kind they are stays. */
    private void sortEffects() {
        for (; sorted < effects.size(); sorted++) {
            Effect effect = effects.get(sorted);
            Optional<LinearLaw> law = effect.getLinearLaw();
            if (law.isPresent()) {
                linear = linear.plus(law.get());
            } else {
                (effect.isPerParticle() ? perParticle : others).add(effect);
            }
        }
    }

    /** The velocities, and the forces of the effects on single particles, for the particles first ... end - 1. */
    void begin(double[] state, double time, double[] dSdt, int first, int end) {
        for (int from = first; from < end; from += STRETCH) {
            int to = Math.min(end, from + STRETCH);
            if (linear == LinearLaw.NONE) {
                copyVelocities(state, dSdt, from, to);
            } else {
                linear.begin(state, particles.masses(), dSdt, from, to);
            }
            for (int e = 0; e < perParticle.size(); e++) {
                perParticle.get(e).addForces(state, time, dSdt, from, to);
            }
        }
    }

    /** The derivative where no force acts. */
    private static void copyVelocities(double[] state, double[] dSdt, int from, int to) {
        for (int x = STRIDE * from; x < STRIDE * to; x += STRIDE) {
            dSdt[x] = state[x + 3];
            dSdt[x + 1] = state[x + 4];
            dSdt[x + 2] = state[x + 5];
            dSdt[x + 3] = 0;
            dSdt[x + 4] = 0;
            dSdt[x + 5] = 0;
        }
    }

    /** Makes forces accelerations. */
    void divideByMasses(double[] dSdt, int from, int to) {
        double[] inverseMasses = particles.inverseMasses();
        for (int i = from, v = STRIDE * from + 3; i < to; i++, v += STRIDE) {
            double inverseMass = inverseMasses[i];
            dSdt[v] *= inverseMass;
            dSdt[v + 1] *= inverseMass;
            dSdt[v + 2] *= inverseMass;
        }
    }

    /** The forces of all effects; 0 where positions stand. */
    void effects(double[] state, double time, double[] force) {
        int n = particles.count();
        Arrays.fill(force, 0, STRIDE * n, 0.0);
        for (int e = 0; e < effects.size(); e++) {
            effects.get(e).addForces(state, time, force, 0, effects.get(e).size());
        }
    }

    boolean dependOnVelocity() {
        boolean depend = false;
        for (int e = 0; e < effects.size(); e++) {
            depend |= effects.get(e).dependsOnVelocity();
        }
        for (int r = 0; r < reactions.size(); r++) {
            depend |= reactions.get(r).dependsOnVelocity();
        }
        return depend;
    }

    void addReactions(double[] state, double time, double[] force) {
        for (int r = 0; r < reactions.size(); r++) {
            Reaction reaction = reactions.get(r);
            if (reaction.isActive()) {
                reaction.addForces(state, time, force);
            }
        }
    }
}
