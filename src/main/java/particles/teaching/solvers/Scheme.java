package particles.teaching.solvers;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.teaching.Formula;

/**
 * A step, known or read from a solver: where and when the derivatives are evaluated, and what the new state is.
 *
 * @param name          its name
 * @param order         its order
 * @param rows          the weights of s, then those of the derivatives in units of deltaT: a row for the state of each
 *                      evaluation, then the new state's. If positions and velocities move in turn, the weights of x, of
 *                      v deltaT, and of the accelerations in units of deltaT^2: a row for the position of each
 *                      evaluation, then the new position's; at last the new velocity's, without x
 * @param times         the times of the evaluations since the step began, in units of deltaT
 * @param isOfParticles whether positions and velocities move in turn
 */
record Scheme(String name, int order, List<double[]> rows, double[] times, boolean isOfParticles) {

    /** @return the number of evaluations */
    int size() {
        return times.length;
    }

    /** @return what a stage's derivative is called */
    String slope(int i) {
        return (isOfParticles ? "a" : "k") + (i + 1);
    }

    /** @return the states of the evaluations; of particles, their positions */
    List<Combination> stages() {
        return IntStream.range(0, size()).mapToObj(i -> row(i, slope(i) + " is evaluated at")).toList();
    }

    /** @return the new state; of particles, the new velocity and the new position */
    List<Combination> ends() {
        return isOfParticles ? List.of(row(size() + 1, "the new velocity is"), row(size(), "the new position is"))
                : List.of(row(size(), "the new state is"));
    }

    /** @return the states that deltaT and the old state make: all, or a particle's new velocity and position */
    List<Combination> states() {
        return Stream.concat(stages().stream().filter(stage -> !isOfParticles), ends().stream()).toList();
    }

    /** @return what moves the position: v deltaT before the first kick, after it, ..., as far as its row says it */
    Combination drifts() {
        List<String> names = new ArrayList<>(List.of("x"));
        double[] lengths = new double[size() + 2];
        lengths[0] = 1;
        for (int i = 0; i <= size(); i++) {
            names.add("v" + i + " deltaT");
            lengths[i + 1] = rows.get(i)[1] - (i == 0 ? 0 : rows.get(i - 1)[1]);
        }
        return new Combination("the new position is", names, 0, 1, lengths);
    }

    /**
     * @param reached the drifts that are made up to each of the positions
     * @param kicks   the kicks in between
     * @return the rows of a method in which all positions are made by drifts with the velocity after each kick
     */
    static List<double[]> inTurn(double[] reached, double[] kicks) {
        List<double[]> rows = new ArrayList<>();
        for (double place : reached) {
            double[] row = new double[2 + rows.size()];
            Arrays.setAll(row, c -> c == 0 ? 1 : c == 1 ? place : kicks[c - 2] * (place - reached[c - 2]));
            rows.add(row);
        }
        rows.add(DoubleStream.concat(DoubleStream.of(0, 1), Arrays.stream(kicks)).toArray());
        return rows;
    }

    /** @return whether it is such a method */
    boolean isInTurn() {
        return isOfParticles && IntStream.range(0, rows.size()).allMatch(r -> Combination.same(rows.get(r), inTurn(
                rows.stream().limit(size() + 1).mapToDouble(row -> row[1]).toArray(), row(size() + 1, "").slopes(
                size())).get(r)));
    }

    private Combination row(int r, String what) {
        boolean velocity = r > size();
        List<String> names = new ArrayList<>(!isOfParticles ? List.of("s") : List.of("x", velocity ? "v"
                : "v deltaT"));
        IntStream.range(0, size()).forEach(j -> names.add(slope(j) + (!isOfParticles ? "" : velocity ? " deltaT"
                : " deltaT^2")));
        return new Combination(what, names, velocity && isOfParticles ? 1 : 0, first(), rows.get(r));
    }

    /** @return the source of the formula: the slide, or the method itself */
    String source() {
        return KnownMethods.ON_SLIDES.contains(name) ? "the slide" : isOfParticles ? "the method" : name;
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

    /** @return the column of the first derivative */
    int first() {
        return isOfParticles ? 2 : 1;
    }

    /** Whether an evaluation enters another one or the new state, or is at a place of its own. */
    private boolean isUsed(int j) {
        return rows.stream().anyMatch(row -> row[first() + j] != 0) || !isOfParticles && j < size() - 1
                && !(Combination.same(rows.get(j), rows.get(j + 1)) && Formula.sameTime(times[j], times[j + 1]));
    }

    /** @return the same without evaluations at the end, or at the next one's place, that enter nothing */
    Scheme withoutUnused() {
        return only(IntStream.range(0, size()).filter(this::isUsed).toArray());
    }

    /** @return the same with the evaluations alone that enter the new state, without those of a first guess */
    Scheme ofTheEnd() {
        return only(IntStream.range(0, size()).filter(j -> rows.stream().skip(size()).anyMatch(row ->
                row[first() + j] != 0)).toArray());
    }

    /** @return the same with these evaluations alone */
    Scheme only(int... kept) {
        List<double[]> left = IntStream.concat(Arrays.stream(kept), IntStream.range(size(), rows.size())).mapToObj(r ->
                DoubleStream.concat(Arrays.stream(rows.get(r)).limit(first()), Arrays.stream(kept).mapToDouble(j ->
                rows.get(r)[first() + j])).toArray()).toList();
        return new Scheme(name, order, left, Arrays.stream(kept).mapToDouble(i -> times[i]).toArray(), isOfParticles);
    }

    /** @return the weights of the new state, each multiplied by its evaluation's time to this power */
    double moment(int power) {
        return IntStream.range(0, size()).mapToDouble(i -> rows.get(size())[1 + i] * StrictMath.pow(times[i], power))
                .sum();
    }
}
