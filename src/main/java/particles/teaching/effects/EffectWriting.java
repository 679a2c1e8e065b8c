package particles.teaching.effects;

import java.util.Arrays;
import java.util.Optional;
import java.util.Random;
import java.util.stream.IntStream;
import particles.law.PerParticleEffect;
import particles.teaching.Finding;
import particles.teaching.Finding.Kind;
import particles.teaching.Formula;

/**
 * Checks how an effect writes its forces, before their values are checked: they have to be added, in the right entries,
 * and not all 0.
 */
record EffectWriting(EffectTrial trial) {
    private static final int TRIALS = 50;
    private static final int STATES = 20;

    /** @return the first mistake; empty if there is none */
    Optional<Finding> finding() {
        return written().or(this::nothing).or(this::elsewhere);
    }

    /** Whether they are also written like that in other states, at other times. */
    private Optional<Finding> elsewhere() {
        Random random = new Random(1687);
        return IntStream.range(0, STATES).mapToObj(j -> EffectTrial.random(trial.system(), trial.effect(), random,
                3 * random.nextDouble())).flatMap(there -> new EffectWriting(there).written().stream()).findFirst();
    }

    static Optional<Finding> wrong(Kind kind, String text) {
        return Optional.of(new Finding(kind, text));
    }

    /** Whether forces are added, where they belong, without touching anything else. */
    private Optional<Finding> written() {
        double[] state = trial.state();
        double[] force = trial.force();
        double[] copy = state.clone();
        trial.force(copy);
        if (!Arrays.equals(copy, state)) {
            return wrong(Kind.STATE, "addForces changes the state");
        }
        if (!Arrays.equals(force, trial.force())) {
            return wrong(Kind.STATE, "two calls at the same state and time give different forces:"
                    + " something is random or kept");
        }
        double[] filled = new double[force.length];
        Arrays.fill(filled, 1);
        trial.effect().addForces(state, trial.time(), filled);
        double[] parts = inTwoRanges(trial);
        for (int k = 0; k < force.length; k++) {
            double rounding = 1e-12 * Math.max(1, Math.abs(force[k]));
            if (!Double.isFinite(force[k])) {
                return wrong(Kind.METHOD, trial.entry(k) + " is " + force[k] + ": look for a division by 0");
            }
            if (k % 6 < 3 && force[k] != 0) {
                return wrong(Kind.STATE, trial.entry(k) + " is written to entry " + k + ", where the position stands;"
                        + " it belongs to entry " + (k + 3));
            }
            if (Math.abs(filled[k] - 1 - force[k]) > rounding) {
                return wrong(Kind.STATE, trial.entry(k) + " is set and not added (= instead of +=)");
            }
            if (Math.abs(parts[k] - force[k]) > rounding) {
                return wrong(Kind.STATE, Formula.text("%s is %s when the particles are asked for in two ranges, and"
                        + " %s at once: the loop has to go from 'from' to 'to'", trial.entry(k), parts[k], force[k]));
            }
        }
        return Optional.empty();
    }

    /** @return the forces; of a law that takes ranges of particles, by two calls */
    static double[] inTwoRanges(EffectTrial trial) {
        if (!(trial.effect() instanceof PerParticleEffect law)) {
            return trial.force();
        }
        int count = trial.size() / 6;
        double[] force = new double[trial.size()];
        law.addForces(trial.state(), trial.time(), force, 0, count / 2);
        law.addForces(trial.state(), trial.time(), force, count / 2, count);
        return force;
    }

    /** Checks that there is a force at all, also at short and long distances and at several times. */
    private Optional<Finding> nothing() {
        Random random = new Random(1895);
        double[] at = trial.state().clone();
        for (int j = 0; j <= TRIALS; j++) {
            double[] force = new double[at.length];
            trial.effect().addForces(at, 3.0 * j / TRIALS, force);
            if (Arrays.stream(force).anyMatch(entry -> entry != 0)) {
                return Optional.empty();
            }
            // from a hundredth of the particles' distance to a hundred
            double spread = StrictMath.pow(10, j % 5 - 2);
            Arrays.setAll(at, k -> k % 6 > 2 && !trial.isFree(k) ? 0 : spread * (random.nextDouble() - 0.5));
        }
        return wrong(Kind.UNWRITTEN, "there is no force on any particle, in " + (TRIALS + 1) + " states");
    }
}
