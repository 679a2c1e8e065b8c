package particles.teaching.effects;

import java.util.Arrays;
import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import particles.ParticleSystem;
import particles.law.Effect;
import particles.law.Effect.Trait;

/**
 * An effect on some particles in one state, as the checks look at it. Finite differences are central, with steps of
 * 1e-5 on numbers of order 1, so their own error is about 1e-10.
 *
 * @param system the particles
 * @param effect the effect, made for them
 * @param state  their state
 * @param time   the time (s)
 */
record EffectTrial(ParticleSystem system, Effect effect, double[] state, double time) {
    private static final double STEP = 1e-5;
    private static final double SPREAD = 0.6;

    /** @return a trial near the places of the system's particles, with velocities of order 1; fixed ones rest */
    static EffectTrial random(ParticleSystem system, Effect effect, Random random, double time) {
        double[] state = new double[system.getStateSize()];
        system.getState(state);
        for (int k = 0; k < state.length; k++) {
            double more = SPREAD * (random.nextDouble() - 0.5);
            state[k] += isVelocity(k) && system.getParticles().isFixed(k / 6) ? 0 : more;
        }
        return new EffectTrial(system, effect, state, time);
    }

    private static boolean isVelocity(int k) {
        return k % 6 > 2;
    }

    /** @return the same effect in another state */
    EffectTrial at(double[] other) {
        return new EffectTrial(system, effect, other, time);
    }

    int size() {
        return state.length;
    }

    /** @return the entries of the velocities, where the forces stand */
    IntStream velocities() {
        return IntStream.range(0, size()).filter(EffectTrial::isVelocity);
    }

    boolean claims(Trait trait) {
        return effect.getTraits().contains(trait);
    }

    boolean isFree(int k) {
        return !system.getParticles().isFixed(k / 6);
    }

    String id(int particle) {
        return "'" + system.getParticles().id(particle) + "'";
    }

    /** @return the meaning of entry k of the forces, in words */
    String entry(int k) {
        return "component " + "xyz".charAt(k % 3) + " of the force on particle " + id(k / 6);
    }

    double[] force(double[] at) {
        double[] force = new double[size()];
        effect.addForces(at, time, force);
        return force;
    }

    double[] force() {
        return force(state);
    }

    /** @return the largest size of an entry, and a tiny number at least */
    static double largest(double[] force) {
        return Math.max(1e-300, Arrays.stream(force).map(Math::abs).max().orElse(0));
    }

    double heat(double[] at) {
        return effect.getDissipatedPower(at, time);
    }

    /** @return the state with one entry moved */
    double[] moved(int k, double by) {
        return changed(m -> m == k, value -> value + by);
    }

    /** @return the state with some entries changed */
    double[] changed(IntPredicate which, DoubleUnaryOperator change) {
        double[] other = state.clone();
        IntStream.range(0, size()).filter(which).forEach(k -> other[k] = change.applyAsDouble(other[k]));
        return other;
    }

    /** @return the state with all velocities multiplied */
    double[] faster(double factor) {
        return changed(EffectTrial::isVelocity, v -> factor * v);
    }

    /** @return the rate at which the potential energy grows in time and the state's own motion (W) */
    double stored(double[] at) {
        double[] ahead = at.clone();
        double[] behind = at.clone();
        velocities().forEach(k -> {
            ahead[k - 3] += STEP * at[k];
            behind[k - 3] -= STEP * at[k];
        });
        return (effect.getPotentialEnergy(ahead, time + STEP) - effect.getPotentialEnergy(behind, time - STEP))
                / (2 * STEP);
    }

    /** @return the power that the law accounts for: what it stores and dissipates less, and drives more (W) */
    double account(double[] at) {
        return effect.getDrivenPower(at, time) - heat(at) - stored(at);
    }

    /** @return the power of the forces (W) */
    double work(double[] at) {
        double[] force = force(at);
        return velocities().mapToDouble(k -> force[k] * at[k]).sum();
    }
}
