package particles.engine;

import deSolvers.ForceDerivatives;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import particles.law.BriefForce;
import particles.law.ConstantForce;
import particles.law.DifferentiableEffect;
import particles.law.Effect;
import particles.law.Particles;
import particles.law.PerParticleEffect;
import particles.law.Reaction;

/** Computes the total force of all effects and reactions, the derivative (v, F/m), and the forces' derivatives. */
public final class ForceSum {
    private static final int STRIDE = Particles.STRIDE;
    /** Particles whose state and derivative stay in the processor's nearest cache while all effects act on them. */
    private static final int CHUNK = 256;
    private final Particles particles;
    private final ConstantForces constant;              // the per-particle effects before the first that varies
    private Optional<Parallel> parallel = Optional.empty();
    // arrays, since loops over lists allocate
    private Effect[] effects = {};
    private PerParticleEffect[] perParticle = {};
    private PerParticleEffect[] varying = {};           // those from the first one that varies on
    private Effect[] others = {};
    private BriefForce[] brief = {};
    private Reaction[] reactions = {};
    private double[] force = {};

    /** A parallel evaluation of the derivative, with the same bits as on one thread. */
    public interface Parallel {
        /** Whether there are enough forces for several threads to be faster. */
        boolean pays();

        /** As {@link ForceSum#derivative}. */
        void derivative(double[] state, double time, double factor, double[] dSdt);
    }

    /** Begins without forces. */
    public ForceSum(Particles particles) {
        this.particles = particles;
        constant = new ConstantForces(particles);
    }

    /** @return the particles */
    public Particles getParticles() {
        return particles;
    }

    /** Adds an effect. */
    public void add(Effect effect) {
        effects = append(effects, effect);
        if (effect instanceof PerParticleEffect each) {
            perParticle = append(perParticle, each);
            if (each instanceof ConstantForce force && varying.length == 0) {
                constant.add(force);
            } else {
                varying = append(varying, each);
            }
        } else {
            others = append(others, effect);
        }
        if (effect instanceof BriefForce force) {
            brief = append(brief, force);
        }
    }

    /** Adds a reaction. */
    public void add(Reaction reaction) {
        reactions = append(reactions, reaction);
    }

    private static <T> T[] append(T[] array, T last) {
        T[] longer = Arrays.copyOf(array, array.length + 1);
        longer[array.length] = last;
        return longer;
    }

    /** All effects, in the order in which they were added. */
    public List<Effect> getEffects() {
        return List.of(effects);
    }

    /** All reactions, in the order of evaluation. */
    public List<Reaction> getReactions() {
        return List.of(reactions);
    }

    /** Computes a multiple of the derivative (v, F/m) of a state. */
    public void derivative(double[] state, double time, double factor, double[] dSdt) {
        constant.update(state, time);
        if (parallel.isPresent() && parallel.get().pays()) {
            parallel.get().derivative(state, time, factor, dSdt);
            return;
        }
        int n = particles.count();
        begin(state, time, factor, dSdt, 0, n);
        for (Effect effect : others) {
            effect.addForces(state, time, dSdt);
        }
        addReactions(state, time, dSdt);
        finish(factor, dSdt, 0, n);
    }

    /** The effects that act on each particle separately. */
    public PerParticleEffect[] getPerParticle() {
        return perParticle;
    }

    /** All other effects, in the order of evaluation. */
    public Effect[] getOthers() {
        return others;
    }

    /** Sets a parallel evaluation, used when it pays. */
    public void setParallel(Optional<Parallel> other) {
        parallel = other;
    }

    /** Computes (factor v, F) of the particles first ... end - 1, with the forces of the per-particle effects. */
    public void begin(double[] state, double time, double factor, double[] dSdt, int first, int end) {
        for (int from = first; from < end; from += CHUNK) {
            int to = Math.min(end, from + CHUNK);
            constant.put(state, factor, dSdt, from, to);
            for (PerParticleEffect effect : varying) {
                effect.addForces(state, time, dSdt, from, to);
            }
        }
    }

    /** Turns (factor v, F) into factor (v, F/m). */
    public void finish(double factor, double[] dSdt, int from, int to) {
        double[] inverseMasses = particles.getInverseMasses();
        for (int v = STRIDE * from + 3, i = from; v < STRIDE * to; v += STRIDE, i++) {
            double inverseMass = inverseMasses[i];
            dSdt[v] = dSdt[v] * inverseMass * factor;
            dSdt[v + 1] = dSdt[v + 1] * inverseMass * factor;
            dSdt[v + 2] = dSdt[v + 2] * inverseMass * factor;
        }
    }

    /** Computes the forces of all effects, with 0 in the entries of positions. */
    public void effects(double[] state, double time, double[] force) {
        Arrays.fill(force, 0, STRIDE * particles.count(), 0.0);
        for (Effect effect : effects) {
            effect.addForces(state, time, force);
        }
    }

    /** Whether any force may come and go within a step. */
    public boolean hasBriefForces() {
        return brief.length > 0;
    }

    /** The shortest time in which any of them may do so (s). */
    public double getShortestTime(double[] state, double time) {
        double shortest = Double.POSITIVE_INFINITY;
        for (BriefForce effect : brief) {
            shortest = Math.min(shortest, effect.getShortestTime(state, time));
        }
        return shortest;
    }

    /** The duration of a sub-step that does not miss the first passage through any force's reach (s). */
    public double findPassage(double[] from, double[] to, double duration) {
        double first = Double.POSITIVE_INFINITY;
        for (BriefForce effect : brief) {
            first = Math.min(first, effect.findPassage(from, to, duration));
        }
        return first;
    }

    /** @return whether any effect or reaction depends on velocities */
    public boolean dependOnVelocity() {
        for (Effect effect : effects) {
            if (effect.dependsOnVelocity()) {
                return true;
            }
        }
        for (Reaction reaction : reactions) {
            if (reaction.dependsOnVelocity()) {
                return true;
            }
        }
        return false;
    }

    /** Adds the forces of all active reactions. */
    public void addReactions(double[] state, double time, double[] force) {
        for (Reaction reaction : reactions) {
            if (reaction.isActive()) {
                reaction.addForces(state, time, force);
            }
        }
    }

    /** The largest acceleration that a single force of any reaction gave in the last evaluation (m/s&sup2;). */
    public double getLargestAcceleration() {
        double largest = 0;
        for (Reaction reaction : reactions) {
            largest = Math.max(largest, reaction.isActive() ? reaction.getLargestAcceleration() : 0);
        }
        return largest;
    }

    /** Whether all effects and active reactions know their derivatives. */
    public boolean hasDerivatives() {
        for (Effect effect : effects) {
            if (!(effect instanceof DifferentiableEffect)) {
                return false;
            }
        }
        for (Reaction reaction : reactions) {
            if (reaction.isActive() && !reaction.hasForceDerivatives()) {
                return false;
            }
        }
        return true;
    }

    /** Adds the derivatives of all effects and active reactions that know them. */
    public void addDerivatives(double[] state, double time, ForceDerivatives derivatives) {
        for (Effect effect : effects) {
            if (effect instanceof DifferentiableEffect known) {
                known.addForceDerivatives(state, time, derivatives);
            }
        }
        boolean forceKnown = false;
        for (Reaction reaction : reactions) {
            if (!reaction.isActive()) {
                continue;
            }
            if (!forceKnown) {
                force = force.length == state.length ? force : new double[state.length];
                effects(state, time, force);
                forceKnown = true;
            }
            if (reaction.hasForceDerivatives()) {
                reaction.addForceDerivatives(state, time, force, derivatives);
            }
            reaction.addForces(state, time, force);
        }
    }
}
