package particles.teaching.effects;

import java.util.Arrays;
import java.util.Map;
import java.util.Optional;
import particles.law.Effect.Trait;
import particles.teaching.Formula;

/**
 * Compares the work of a damping law with the dissipated power that it reports, and finds the cause of a difference.
 */
record EffectPower(EffectTrial trial) {
    private static final double SAME = 1e-5;
    private static final Map<Double, String> RATIOS = Map.of(
            -1.0, ": the sign is wrong; damping has to push against the velocity",
            2.0, ": twice as much; a half stands in the dissipated power that does not belong there",
            0.5, ": half as much; a half is missing in the dissipated power, or is too much in the force");

    /** @return the mistake of a law that declares DISSIPATIVE and not DRIVING; empty if there is none */
    Optional<String> wrong() {
        if (!trial.claims(Trait.DISSIPATIVE) || trial.claims(Trait.DRIVING)) {
            return Optional.empty();
        }
        double[] state = trial.state();
        double dissipated = trial.heat(state);
        double power = power(state);
        if (Math.abs(power + dissipated) <= SAME * Math.max(1e-3, Math.abs(power))) {
            return dissipated < -SAME ? Optional.of(Formula.text("getDissipatedPower is %s W, and heat is never"
                    + " negative: the sign is wrong in the force too, which has to push against the velocity",
                    dissipated)) : Optional.empty();
        }
        boolean moving = !Arrays.equals(trial.force(), trial.force(trial.faster(0)));
        if (dissipated == 0 && !moving) {
            return Optional.of("it claims DISSIPATIVE, but " + trial.effect().getName() + " is not: its force is the"
                    + " same at all velocities. Claim CONSERVATIVE with getPotentialEnergy, or DRIVING with"
                    + " getDrivenPower");
        }
        return Optional.of(Formula.text("the forces do the work %s W and the effect says that it turns %s W into heat",
                power, dissipated) + cause(power, dissipated, moving));
    }

    /** F . v plus the rate of the potential energy. */
    private double power(double[] at) {
        return trial.work(at) + trial.stored(at);
    }

    private String cause(double power, double dissipated, boolean moving) {
        if (dissipated == 0) {
            return ": getDissipatedPower is missing";
        }
        double ratio = -power / dissipated;
        for (Map.Entry<Double, String> known : RATIOS.entrySet()) {
            if (Math.abs(ratio - known.getKey()) < 1e-4) {
                return ratio < 0 && dissipated < 0 ? ": the sign of the dissipated power is wrong; what becomes heat"
                        + " counts as positive" : known.getValue();
            }
        }
        if (moving && Arrays.equals(trial.force(trial.faster(-1)), trial.force())) {
            return ": the force is the same when all velocities are turned round, and has to be turned round with them;"
                    + " |v| v is meant, and not v v";
        }
        EffectTrial rest = trial.at(trial.faster(0));
        double[] force = rest.force();
        double size = EffectTrial.largest(force);
        return size <= SAME || rest.velocities().anyMatch(k -> rest.energy(rest.moved(k - 3, 1)) != rest.energy(
                rest.state())) ? entryByEntry(rest) : rest.velocities().anyMatch(k -> Math.abs(rest.force(rest.moved(
                k - 3, 1))[k] - force[k]) > SAME * size)
                ? ": there is a force at rest too, which stores energy; getPotentialEnergy is missing"
                : ": there is a force at rest too, which drives; claim DRIVING and return its power in getDrivenPower";
    }

    /** Checks one velocity at a time: the dissipated power determines the force along it. */
    private String entryByEntry(EffectTrial rest) {
        double[] force = new double[rest.size()];
        double[] expected = new double[rest.size()];
        rest.velocities().forEach(k -> {
            double[] moving = rest.changed(m -> m == k, v -> 1);
            force[k] = rest.force(moving)[k];
            expected[k] = force[k] - power(moving) - rest.heat(moving);
        });
        return new ForceComparison(trial, force, expected).cause(true, "the dissipated power");
    }
}
