package particles.teaching.solvers;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import particles.teaching.Formula;

/**
 * A step, known or read from a solver: where and when the derivatives are evaluated, and what the new state is.
 *
 * @param name   its name
 * @param order  its order
 * @param stages the states of the evaluations; of particles, their positions
 * @param times  the times of the evaluations since the step began, in units of deltaT
 * @param ends   the new state; of particles, the new velocity and the new position
 */
record Scheme(String name, int order, List<Combination> stages, double[] times, List<Combination> ends) {

    /**
     * A method with one formula for all of the state.
     *
     * @param rows  the weights of the old state, then those of the derivatives in units of deltaT: the stages' rows,
     *              then the new state's
     * @param times the times of the stages
     */
    static Scheme oneFormula(String name, int order, List<double[]> rows, double[] times) {
        return of(name, order, "k", rows, List.of("s"), times);
    }

    /**
     * A method that moves positions and velocities in turn.
     *
     * @param rows  the weights of x, of v deltaT, and of the accelerations in units of deltaT^2: the rows of the
     *              evaluations' positions, then the new position's; at last the new velocity's row, without v deltaT
     * @param times the times of the evaluations
     */
    static Scheme ofParticles(String name, int order, List<double[]> rows, double[] times) {
        int n = times.length;
        List<String> names = new ArrayList<>(List.of("v"));
        IntStream.rangeClosed(1, n).forEach(j -> names.add("a" + j + " deltaT"));
        Scheme positions = of(name, order, "a", rows.subList(0, n + 1), List.of("x", "v deltaT"), times);
        return new Scheme(name, order, positions.stages, times, List.of(new Combination("the new velocity is", names,
                rows.get(n + 1)), new Combination("the new position is", positions.ends.get(0).names(), rows.get(n))));
    }

    private static Scheme of(String name, int order, String letter, List<double[]> rows, List<String> first,
            double[] times) {
        List<String> names = new ArrayList<>(first);
        IntStream.rangeClosed(1, times.length).forEach(j -> names.add(letter + j + (first.size() > 1 ? " deltaT^2"
                : "")));
        return new Scheme(name, order, IntStream.range(0, times.length).mapToObj(i -> new Combination(letter + (i + 1)
                + " is evaluated at", names, rows.get(i))).toList(), times, List.of(new Combination("the new state is",
                names, rows.get(times.length))));
    }

    boolean isOfParticles() {
        return ends.size() == 2;
    }

    /** @return the number of evaluations */
    int size() {
        return times.length;
    }

    /** @return what a stage's derivative is called */
    String slope(int i) {
        return (isOfParticles() ? "a" : "k") + (i + 1);
    }

    /** @return the source of the formula: the slide, or the method itself */
    String source() {
        return KnownMethods.ON_SLIDES.contains(name) ? "the slide" : isOfParticles() ? "the method" : name;
    }

    /** @return a text in the slides' own words, where they have some for this method */
    String words(String text) {
        return switch (name) {
            case KnownMethods.EULER -> text.replace("k1 is", "dSdt is").replace("k1", "deltaS");
            case KnownMethods.MIDPOINT -> text.replace("k1 is", "dSdt is").replace("k2 is", "gMid is")
                    .replace("k1", "deltaS").replaceAll("(of|and) k2", "$1 gMid").replace("k2", "deltaT gMid");
            default -> text;
        };
    }

    private int firstSlope() {
        return isOfParticles() ? 2 : 1;
    }

    /** @return whether an evaluation enters another one or the new state */
    private boolean isUsed(int j) {
        return stages.stream().anyMatch(row -> row.weight(firstSlope() + j) != 0) || IntStream.range(0, ends.size())
                .anyMatch(e -> ends.get(e).weight(1 + e + j) != 0);
    }

    /** @return the same without evaluations at the end, or at the next one's place, that enter nothing */
    Scheme withoutUnused() {
        int[] kept = IntStream.range(0, size()).filter(j -> isUsed(j) || !isOfParticles() && j < size() - 1 && !(stages
                .get(j).is(stages.get(j + 1)) && Formula.sameTime(times[j], times[j + 1]))).toArray();
        List<double[]> rows = new ArrayList<>();
        Arrays.stream(kept).forEach(i -> rows.add(columns(stages.get(i), firstSlope(), kept)));
        for (int e = ends.size() - 1; e >= 0; e--) {
            rows.add(columns(ends.get(e), e + 1, kept));
        }
        double[] left = Arrays.stream(kept).mapToDouble(i -> times[i]).toArray();
        return isOfParticles() ? ofParticles(name, order, rows, left) : oneFormula(name, order, rows, left);
    }

    private static double[] columns(Combination row, int first, int[] kept) {
        double[] weights = Arrays.copyOf(row.weights(), first + kept.length);
        Arrays.setAll(weights, j -> row.weight(j < first ? j : first + kept[j - first]));
        return weights;
    }
}
