package particles.experiments.runs;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import particles.view.Axis;
import particles.view.Chart;
import particles.view.Look;
import particles.view.Series;
import particles.view.Series.Mark;

/**
 * Charts of runs: quantities of them over one axis, with a curve for each solver, or for whatever else varies.
 *
 * @param <R>    a run
 * @param curves the curves
 * @param x      the axis of all charts
 * @param place  the place of a run on it; finite
 */
public record RunCharts<R>(List<Curve<R>> curves, Axis x, ToDoubleFunction<R> place) {

    /**
     * A curve.
     *
     * @param <R>  a run
     * @param name its name
     * @param look its look
     * @param runs the runs at its points
     */
    public record Curve<R>(String name, Look look, List<R> runs) {
    }

    /** @return the charts with a curve for each solver, in the order of the runs */
    public static <R> RunCharts<R> of(List<R> runs, Function<R, SolverChoice> solver, Axis x,
            ToDoubleFunction<R> place) {
        Map<SolverChoice, List<R>> curves = runs.stream().collect(Collectors.groupingBy(solver, LinkedHashMap::new,
                Collectors.toList()));
        return new RunCharts<>(curves.entrySet().stream().map(curve -> new Curve<>(curve.getKey().label(),
                curve.getKey().look(), curve.getValue())).toList(), x, place);
    }

    /**
     * @param y     the axis of a quantity
     * @param value the quantity; NaN where a run has none
     * @param end   what stands at the end of a curve through these runs; the last value if it is empty
     * @return the chart; below it, if there are any, the runs without a value, in a row for each curve
     */
    public List<Chart> charts(Axis y, ToDoubleFunction<R> value, Function<List<R>, String> end) {
        List<Series> series = new ArrayList<>();
        List<Series> missing = new ArrayList<>();
        List<String> rows = new ArrayList<>();
        for (Curve<R> curve : curves) {
            Series line = Series.of(curve.look, curve.name, Mark.LINE_AND_POINTS, curve.runs, place, value);
            String words = end.apply(curve.runs);
            series.add(words.isEmpty() ? line.ending(y) : line.ending(words));
            List<R> without = curve.runs.stream().filter(run -> Double.isNaN(value.applyAsDouble(run))).toList();
            if (!without.isEmpty()) {
                int row = rows.size();
                rows.add(curve.name);
                missing.add(Series.of(curve.look, "no result", Mark.FAILURES, without, place, run -> row));
            }
        }
        return new Chart(x, y, series).above("no result", rows, missing);
    }
}
