package particles.teaching.effects;

import java.util.List;
import java.util.Optional;
import java.util.function.IntFunction;
import java.util.function.IntUnaryOperator;
import java.util.stream.IntStream;
import particles.teaching.Formula;

/**
 * Compares forces with the expected ones, and looks for a common pattern of the differences.
 *
 * @param trial    the particles on which they act
 * @param force    the forces, in the entries of the velocities
 * @param expected the right forces, likewise
 */
record ForceComparison(EffectTrial trial, double[] force, double[] expected) {
    private static final double SAME = 1e-5;
    private static final List<Pattern> PATTERNS = List.of(
            new Pattern(-1, 0, "the sign is wrong, in the force or in %s"),
            new Pattern(0.5, 0, "the half is missing in %s, or one was taken too often in the force"),
            new Pattern(2, 0, "the force is twice what it should be, or a half too many stands in %s"),
            new Pattern(1, -1, "the mass is missing in the force, which is mass times acceleration"),
            new Pattern(1, 1, "the mass is missing in %s, or stands in the force once too often"));

    /** The mistake if the force is this factor and power of the mass times the right one. */
    private record Pattern(double factor, int power, String mistake) {
    }

    private double size() {
        return Math.max(EffectTrial.largest(force), EffectTrial.largest(expected));
    }

    /** @return the entries of free particles whose forces differ */
    IntStream wrong() {
        return trial.velocities().filter(k -> trial.isFree(k) && Math.abs(force[k] - expected[k]) > SAME * size());
    }

    /**
     * @param velocities whether the forces depend on velocities
     * @param other      the origin of the right forces, in words
     * @return the likely mistake, after a colon; empty if nothing is common to all differences
     */
    String cause(boolean velocities, String other) {
        if (EffectTrial.largest(expected) <= SAME * size()) {
            return velocities ? ": a force that depends on the velocity is not"
                    + " CONSERVATIVE; claim DISSIPATIVE if it damps"
                    : ": " + other + " is the same everywhere; getPotentialEnergy is missing (1/2 is 0 in "
                    + "Java, 0.5 is meant), or the claim CONSERVATIVE is wrong";
        }
        int largest = trial.velocities().boxed().max((i, k) -> Double.compare(Math.abs(expected[i]), Math.abs(
                expected[k]))).orElseThrow();
        double factor = force[largest] / expected[largest];
        return leftOut().or(() -> PATTERNS.stream().filter(one -> fits(one.factor, one.power)).map(one -> ": "
                + Formula.text(one.mistake, other)).findFirst()).or(() -> Optional.of(": all of it is "
                + Formula.number(factor) + " times what it should be").filter(text -> fits(factor, 0)))
                .or(() -> velocities ? Optional.empty() : centre()).orElseGet(() -> {
                    List<String> off = names(k -> k % 3, "xyz"::charAt);
                    List<String> on = names(k -> k / 6, trial::id);
                    return off.size() < 3 ? ": only " + String.join(" and ", off) + (off.size() == 1 ? " is" : " are")
                            + " wrong" : trial.velocities().filter(k -> trial.isFree(k) && !on.contains(trial.id(k
                            / 6))).findAny().isEmpty() ? "" : ": it is wrong on " + String.join(", ", on)
                            + " and right on all others: compare the conditions, such as the range, of force and "
                            + other;
                });
    }

    /** Springs to different centres differ by a force that is the same everywhere. */
    private Optional<String> centre() {
        int first = wrong().findFirst().orElse(3) / 6 * 6;
        boolean same = trial.velocities().filter(trial::isFree).allMatch(k -> Math.abs(force[k] - expected[k] - force[
                first + 3 + k % 3] + expected[first + 3 + k % 3]) <= SAME * size());
        return Optional.of(": the difference is the same on every particle: the force pulls to another centre, or a"
                + " constant force stands in one of the two only").filter(text -> same);
    }

    private List<String> names(IntUnaryOperator of, IntFunction<?> name) {
        return wrong().map(of).distinct().sorted().mapToObj(name).map(String::valueOf).toList();
    }

    /** Finds particles without any force, if all others have the right one. */
    private Optional<String> leftOut() {
        boolean none = wrong().map(k -> k / 6).distinct().allMatch(i -> IntStream.range(6 * i + 3, 6 * i + 6).allMatch(
                k -> force[k] == 0));
        List<String> names = names(k -> k / 6, trial::id);
        return !none || names.isEmpty() ? Optional.empty() : Optional.of(": there is no force on particle "
                + String.join(", ", names) + ", and the right one on all others; "
                + "the loop has to begin at 0 and go while i < particles.count()");
    }

    /** Whether force = factor * mass^power * expected, for all free particles. */
    private boolean fits(double factor, int power) {
        return trial.velocities().filter(trial::isFree).allMatch(k -> Math.abs(force[k] - factor * expected[k]
                * StrictMath.pow(trial.system().getParticles().mass(k / 6), power)) <= SAME * size() * 2);
    }
}
