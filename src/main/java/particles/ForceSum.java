package particles;

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
    private int summedUp;                               // how many effects the law above is the sum of

    ForceSum(Particles particles, List<Effect> effects, List<Reaction> reactions) {
        this.particles = particles;
        this.effects = effects;
        this.reactions = reactions;
    }

    /** The derivative (v, F/m) of a state. */
    void derivative(double[] state, double time, double[] dSdt) {
        if (summedUp < effects.size()) {
            sumUpLinearLaws();
        }
        if (parallel.isPresent() && parallel.get().pays()) {
            parallel.get().derivative(state, time, dSdt);
            return;
        }
        int n = particles.count();
        begin(state, time, dSdt, 0, n);
        addOthers(state, time, dSdt);
        addReactions(state, time, dSdt);
        divideByMasses(dSdt, 0, n);
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

    /** Effects are added and never taken out, and their linear laws stay as they are. */
    private void sumUpLinearLaws() {
        for (; summedUp < effects.size(); summedUp++) {
            Optional<LinearLaw> law = effects.get(summedUp).getLinearLaw();
            if (law.isPresent()) {
                linear = linear.plus(law.get());
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
            addPerParticle(state, time, dSdt, from, to, false);
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
        for (int from = 0; from < n; from += STRETCH) {
            addPerParticle(state, time, force, from, Math.min(n, from + STRETCH), true);
        }
        addOthers(state, time, force);
    }

    private void addPerParticle(double[] state, double time, double[] force, int from, int to, boolean linearToo) {
        for (int e = 0; e < effects.size(); e++) {
            Effect effect = effects.get(e);
            if (effect.isPerParticle() && (linearToo || effect.getLinearLaw().isEmpty())) {
                effect.addForces(state, time, force, from, to);
            }
        }
    }

    private void addOthers(double[] state, double time, double[] force) {
        for (int e = 0; e < effects.size(); e++) {
            Effect effect = effects.get(e);
            if (!effect.isPerParticle()) {
                effect.addForces(state, time, force, 0, effect.size());
            }
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
