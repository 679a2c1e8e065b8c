package particles.teaching.effects;

import java.util.Arrays;
import java.util.Optional;
import java.util.Random;
import particles.ParticleSystem;
import particles.law.Effect;
import particles.law.PerParticleEffect;
import particles.teaching.Finding;
import particles.teaching.Finding.Kind;
import particles.teaching.Formula;

/**
 * Checks how an effect writes its forces, before their values are checked: they have to be added, in the right entries,
 * and not all 0.
 */
final class EffectWriting {
    private static final int TRIALS = 50;
    private static final String XYZ = "xyz";

    private final ParticleSystem system;
    private final Effect effect;
    private final double[] state;
    private final int n;

    EffectWriting(ParticleSystem system, Effect effect, double[] state) {
        this.system = system;
        this.effect = effect;
        this.state = state;
        n = state.length;
    }

    /** @return the first mistake; empty if there is none */
    Optional<Finding> finding() {
        return written().or(this::nothing);
    }

    private static Optional<Finding> wrong(Kind kind, String text) {
        return Optional.of(new Finding(kind, text));
    }

    private double[] force(double[] at) {
        double[] force = new double[n];
        effect.addForces(at, 0, force);
        return force;
    }

    /** @return the meaning of entry k of an array of the state's layout, in words */
    static String entry(ParticleSystem system, int k) {
        return "component " + axis(k) + " of the force on particle '" + system.getParticles().id(k / 6) + "'";
    }

    /** @return x, y or z */
    static char axis(int k) {
        return XYZ.charAt(k % 3);
    }

    /** Whether forces are added, where they belong, without touching anything else. */
    private Optional<Finding> written() {
        double[] force = force(state);
        double[] copy = state.clone();
        force(copy);
        if (!Arrays.equals(copy, state)) {
            return wrong(Kind.STATE, "addForces changes the state, which is there to be read only");
        }
        if (!Arrays.equals(force, force(state))) {
            return wrong(Kind.STATE, "two calls at the same state and time give different forces: something is random,"
                    + " or kept from the call before");
        }
        double[] filled = new double[n];
        Arrays.fill(filled, 1);
        effect.addForces(state, 0, filled);
        for (int k = 0; k < n; k++) {
            if (!Double.isFinite(force[k])) {
                return wrong(Kind.METHOD, entry(system, k) + " is " + force[k]
                        + " at a state that is nothing special: look for a division by 0");
            }
            if (k % 6 < 3 && force[k] != 0) {
                return wrong(Kind.STATE, entry(system, k) + " is written to entry " + k
                        + ", where the position stands; it belongs where the velocity stands,"
                        + " entry " + (k + 3));
            }
            if (k % 6 >= 3 && Math.abs(filled[k] - 1 - force[k]) > 1e-12 * Math.max(1, Math.abs(force[k]))) {
                return wrong(Kind.STATE, entry(system, k) + " is set and not added (= instead of +=):"
                        + " the forces of other effects are lost");
            }
        }
        double[] parts = inTwoRanges(effect, state, 0).orElse(force);
        for (int k = 0; k < n; k++) {
            if (Math.abs(parts[k] - force[k]) > 1e-12 * Math.max(1, Math.abs(force[k]))) {
                return wrong(Kind.STATE, entry(system, k) + " is " + Formula.number(parts[k])
                        + " when the particles are asked for in two ranges, one"
                        + " after the other, and " + Formula.number(force[k])
                        + " at once: the loop has to go from 'from' to 'to', and over nothing else");
            }
        }
        return Optional.empty();
    }

    /** @return the forces of a law that takes ranges of particles, by two calls; empty for all other laws */
    static Optional<double[]> inTwoRanges(Effect effect, double[] state, double time) {
        if (!(effect instanceof PerParticleEffect law)) {
            return Optional.empty();
        }
        double[] force = new double[state.length];
        int count = state.length / 6;
        law.addForces(state, time, force, 0, count / 2);
        law.addForces(state, time, force, count / 2, count);
        return Optional.of(force);
    }

    /** Checks that there is a force at all, also at short and long distances and at several times. */
    private Optional<Finding> nothing() {
        Random random = new Random(1895);
        double[] at = state.clone();
        for (int trial = 0; trial <= TRIALS; trial++) {
            double[] force = new double[n];
            effect.addForces(at, 3.0 * trial / TRIALS, force);
            if (Arrays.stream(force).anyMatch(entry -> entry != 0)) {
                return Optional.empty();
            }
            // from a hundredth of the particles' distance to a hundred
            double spread = StrictMath.pow(10, trial % 5 - 2);
            for (int k = 0; k < n; k++) {
                at[k] = k % 6 >= 3 && system.getParticles().isFixed(k / 6) ? 0 : spread * (random.nextDouble() - 0.5);
            }
        }
        return wrong(Kind.METHOD, "there is no force on any particle, in " + (TRIALS + 1)
                + " states of all sizes: the law's formula is still missing");
    }
}
