package particles.teaching.effects;

import java.util.List;
import java.util.Optional;
import java.util.function.IntFunction;
import java.util.function.IntUnaryOperator;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import particles.teaching.Formula;

/**
 * Compares each component of the forces with the one that the law's energies ask for: while one particle moves along
 * one axis, and all others rest, the power of the force on it has to be the one that they account for.
 *
 * @param trial    the particles
 * @param velocity the velocity of the one that moves (m/s)
 * @param force    the forces, in the entries of the velocities
 * @param expected those that the energies ask for, likewise
 */
record ForceComparison(EffectTrial trial, double velocity, double[] force, double[] expected) {
    private static final double SAME = 1e-5;
    private static final double MOVE = 1e-3;

    /** @return the comparison at this velocity (m/s) */
    static ForceComparison of(EffectTrial trial, double velocity) {
        double[] force = new double[trial.size()];
        double[] expected = new double[trial.size()];
        trial.velocities().filter(trial::isFree).forEach(k -> {
            double[] moving = moving(trial, k, velocity);
            force[k] = trial.force(moving)[k];
            expected[k] = trial.account(moving) / velocity;
        });
        return new ForceComparison(trial, velocity, force, expected);
    }

    private static double[] moving(EffectTrial trial, int k, double velocity) {
        double[] moving = trial.faster(0);
        moving[k] = velocity;
        return moving;
    }

    private double same() {
        return SAME * Math.max(EffectTrial.largest(force), EffectTrial.largest(expected));
    }

    private IntStream wrong() {
        return trial.velocities().filter(k -> Math.abs(force[k] - expected[k]) > same());
    }

    /** @return the first component that differs, and what all that differ have in common; empty if none does */
    Optional<String> difference() {
        return wrong().boxed().findFirst().map(k -> Formula.text("%s is %s N while it moves along it at %s m/s;"
                + " getPotentialEnergy, getDissipatedPower and getDrivenPower ask for %s N%s; the force changes with"
                + " these entries of the state: %s", trial.entry(k), force[k], velocity, expected[k], common(),
                entries(k)));
    }

    /** The entries of the state with which a component changes. */
    private List<Integer> entries(int k) {
        EffectTrial there = trial.at(moving(trial, k, velocity));
        return IntStream.range(0, trial.size()).filter(m -> there.force(there.moved(m, MOVE))[k] != force[k]).boxed()
                .toList();
    }

    private String common() {
        int largest = trial.velocities().boxed().max((i, k) -> Double.compare(Math.abs(expected[i]), Math.abs(
                expected[k]))).orElseThrow();
        double factor = force[largest] / expected[largest];
        if (EffectTrial.largest(expected) <= same()) {
            return " on every particle: one of them is missing (1/2 is 0 in Java, 0.5 is meant), or a claim is wrong";
        }
        boolean all = trial.velocities().allMatch(k -> Math.abs(force[k] - factor * expected[k]) <= 2 * same());
        return all ? Formula.text("; on all particles the force is %s times that", factor) : "; wrong are " + names(k ->
                k % 3, axis -> "xyz".charAt(axis)) + " on " + names(k -> k / 6, trial::id);
    }

    private String names(IntUnaryOperator of, IntFunction<?> name) {
        return wrong().map(of).distinct().sorted().mapToObj(name).map(String::valueOf).collect(Collectors.joining(
                ", "));
    }
}
