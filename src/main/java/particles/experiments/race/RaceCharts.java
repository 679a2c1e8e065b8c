package particles.experiments.race;

import static java.util.stream.Collectors.joining;
import static particles.view.DataTable.column;

import deSolvers.text.Digits;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import particles.experiments.energy.DriftCharts;
import particles.experiments.energy.EnergyDrift.Comparison;
import particles.experiments.race.Race.Lane;
import particles.experiments.race.Race.Result;
import particles.experiments.runs.EqualTime;
import particles.experiments.runs.SolverChoice;
import particles.view.ChartData;
import particles.view.ChartData.Mark;
import particles.view.ChartData.Series;
import particles.view.DataTable;

/** Charts, tables and findings of a race. */
public final class RaceCharts {
    private static final double SMALLEST = 1e-17;
    /**
     * Times of the same run differ by some percent; a solver that takes this many times as long had more
     * than equal work.
     */
    private static final double TOO_MUCH = 1.2;
    /**
     * Solvers within this factor of the nearest share the first place: their order is chance.
     */
    private static final double AS_NEAR = 1.1;
    /** A distance below this part of the largest coordinate is round-off. */
    private static final double ROUND_OFF = 1e-12;

    private RaceCharts() {
    }

    /**
     * @param race the result of the race
     * @return the energy error of each solver over time, with a cross where a solver left the race
     */
    public static ChartData energy(Result race) {
        Comparison comparison = new Comparison(race.scene(), race.scale(), !race.equalTime(), true,
                race.lanes().stream().map(Lane::drift).toList());
        return DriftCharts.charts(comparison).get(0);
    }

    /**
     * @param race the result of the race
     * @return the distance of each solver from the reference, over time
     */
    public static ChartData distance(Result race) {
        List<Series> series = new ArrayList<>();
        List<double[]> left = new ArrayList<>();
        for (Lane lane : race.lanes()) {
            List<double[]> known = IntStream.range(1, lane.distance().length)
                    .filter(k -> lane.distance()[k] >= SMALLEST)
                    .mapToObj(k -> new double[] {race.times()[k], lane.distance()[k]}).toList();
            series.add(Series.of(lane.label(), Mark.LINE, known));
            if (lane.left().isPresent() && !known.isEmpty()) {
                left.add(known.get(known.size() - 1));
            }
        }
        if (!left.isEmpty()) {
            series.add(Series.of(DriftCharts.LEFT, Mark.FAILURES, left));
        }
        return new ChartData(title(race), "time (s)", "distance from the reference (m)", false, true, series);
    }

    /**
     * @param race the result of the race
     * @return the work of each, such as {@code equal work, 1000 evaluations for the whole race}, and how nearly equal
     *         it was
     */
    public static String work(Result race) {
        double work = race.shares().work();
        if (!race.equalTime()) {
            return Digits.format("equal work, %d evaluations for the whole race", Math.round(work));
        }
        double spread = EqualTime.spread(race.shares());
        return spread > TOO_MUCH - 1 ? Digits.format("no equal time, up to %.3g times as long", 1 + spread)
                : Digits.format("equal time, %.3g ms each to within %.0f %%", 1000 * work,
                        Math.ceil(100 * spread));
    }

    /**
     * @param race the result of the race
     * @return the scene, the kind of equal work, the winner and the solvers that left
     */
    public static String title(Result race) {
        String finding = finding(race);
        return race.scene() + ", " + work(race) + (finding.isEmpty() ? "" : ": " + finding);
    }

    /**
     * @param race the result of the race
     * @return a sentence about the winner and the solvers that left; may be empty
     */
    public static String finding(Result race) {
        List<String> parts = new ArrayList<>();
        parts.add(nearest(race));
        List<Lane> left = race.lanes().stream().filter(lane -> lane.left().isPresent()).toList();
        if (!left.isEmpty()) {
            parts.add(left.size() > 3 ? left.size() + " solvers leave the race" : left.stream().map(lane -> lane.label()
                    + " " + DriftCharts.verdict(lane.drift(), true)).collect(joining(", ")));
        }
        for (Lane lane : race.lanes()) {
            double cost = share(race, lane);
            if (cost > TOO_MUCH && lane.left().isEmpty()) {
                parts.add(lane.label() + Digits.format(" cannot do with less than %.3g times the %s", cost,
                        race.equalTime() ? "time" : "work"));
            }
        }
        parts.removeIf(String::isEmpty);
        return String.join("; ", parts);
    }

    /** The solvers that stay nearest; may be empty. A solver that needed more than its share is left out. */
    private static String nearest(Result race) {
        List<Lane> compared = race.lanes().stream().filter(lane -> lane.left().isEmpty() && mean(lane) >= 0
                && share(race, lane) <= TOO_MUCH).toList();
        double nearest = compared.stream().mapToDouble(RaceCharts::mean).min().orElse(0);
        double size = race.reference().stream().flatMapToDouble(Arrays::stream).map(Math::abs).max().orElse(0);
        return SolverChoice.said(compared.stream().filter(lane -> mean(lane) <= AS_NEAR * nearest + ROUND_OFF * size)
                .map(Lane::label).toList(), compared.size() > 1 ? "stays nearest to the reference on average"
                : "is " + Digits.few(nearest) + " m from the reference on average");
    }

    /** The work of a lane, divided by the work that each was to have. */
    private static double share(Result race, Lane lane) {
        return (race.equalTime() ? lane.match().seconds() : lane.match().evaluations())
                / race.shares().work();
    }

    /** Root mean square over the frames (m); NaN where there is nothing to compare. */
    private static double mean(Lane lane) {
        return Math.sqrt(Arrays.stream(lane.distance()).filter(d -> d >= 0).map(d -> d * d).average()
                .orElse(Double.NaN));
    }

    /**
     * @param race the result of the race
     * @return the table, with a row for each solver
     */
    public static DataTable table(Result race) {
        return DataTable.of("race", race.scene() + ", " + work(race), race.lanes(), column("solver", Lane::label),
                column("deltaT (s)", lane -> lane.match().setting().deltaT()),
                column("tolerance", 2, lane -> lane.match().setting().tolerance().orElse(Double.NaN)),
                column("evaluations", lane -> lane.drift().outcome().evaluations()),
                column("time (ms)", 3, lane -> 1000 * lane.match().seconds()),
                column("distance, rms (m)", 3, RaceCharts::mean),
                column("at the end (m)", 3, lane -> lane.left().isPresent() ? Double.NaN
                        : lane.distance()[lane.distance().length - 1]),
                column("largest energy error / scale", 2, lane -> lane.drift().largest()),
                column("left the race at (s)", 3, lane -> lane.left().orElse(Double.NaN)),
                column("what went wrong", lane -> lane.drift().outcome().failure().orElse(""))).withoutEmptyColumns();
    }
}
