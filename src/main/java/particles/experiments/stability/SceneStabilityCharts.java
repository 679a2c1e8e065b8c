package particles.experiments.stability;

import deSolvers.catalog.SolverCatalog;
import deSolvers.text.Digits;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import particles.experiments.runs.SolverChoice;
import particles.experiments.stability.SceneStability.Limit;
import particles.experiments.stability.StabilityRegion.Window;
import particles.view.ChartData;
import particles.view.ChartData.Mark;
import particles.view.ChartData.Series;

/**
 * Charts of a scene's stability: its eigenvalues in the solvers' stability regions, and the growth per step over
 * deltaT.
 */
public final class SceneStabilityCharts {
    private static final int POINTS = 400;
    private static final double CELLS = 90;
    /** An outline lower than this part of the chart would be hidden by a mode at 0. */
    private static final double SEEN = 0.05;
    /** At more than so many times the longest stable step, modes are far from all outlines. */
    private static final double FAR_TOO_LONG = 5;
    /** Beyond this factor per step is far from safe, and all lines look alike. */
    private static final double TOP = 2;

    private SceneStabilityCharts() {
    }

    /**
     * @param scene    the title of the scene
     * @param spectrum the spectrum of its start
     * @param deltaT   the scene's step (s)
     * @param solvers  catalogue names whose outlines are drawn
     * @return the chart of the step times each eigenvalue, with the outlines of the regions that are large enough to be
     *         seen, and its upper half, which is the same as the lower one, for a wide page; where the scene's step is
     *         far too long for all solvers, it is drawn at the longest that is stable with one
     */
    public static List<ChartData> plane(String scene, Spectrum spectrum, double deltaT, List<String> solvers) {
        Map<String, Double> limits = new LinkedHashMap<>();
        solvers.forEach(solver -> limits.put(solver, new SpectrumLimit(SolverCatalog.info(solver), spectrum).deltaT()));
        double longest = limits.values().stream().reduce(0.0, Math::max);
        double step = longest > 0 && deltaT > FAR_TOO_LONG * longest ? longest : deltaT;
        List<String> stable = solvers.stream().filter(solver -> limits.get(solver) >= deltaT).toList();
        boolean divided = solvers.stream().anyMatch(solver -> SolverCatalog.info(solver).adaptive()
                && limits.get(solver) < Double.POSITIVE_INFINITY);
        String title = scene + ": a step " + (divided ? "or sub-step " : "") + "of " + Digits.few(deltaT)
                + " s is stable with " + (stable.isEmpty() ? "no solver shown" : SolverChoice.together(stable))
                + (step == deltaT ? "" : "; drawn for " + Digits.few(step) + " s, the longest that is stable with "
                + Collections.max(solvers, Comparator.comparing(limits::get)));
        List<double[]> points = spectrum.modes().stream().map(mode ->
                new double[] {step * mode.re(), step * mode.im()}).toList();
        double far = spectrum.modes().stream().mapToDouble(mode -> 1.1 * step * mode.size()).reduce(3, Math::max);
        Series upper = Series.of("modes of the scene", Mark.POINTS, points);
        Series both = Series.of(upper.name(), Mark.POINTS, Stream.concat(points.stream(), points.stream().map(point ->
                new double[] {point[0], -point[1]})).toList());
        ChartData half = StabilityRegion.outlines(solvers, new Window(-1.2 * far, 0.4 * far, 0, far, far / CELLS));
        ChartData whole = StabilityRegion.outlines(solvers, new Window(-far, far / 3, -far, far, far / CELLS));
        return List.of(add(title, whole, both, far), add(title, half, upper, far));
    }

    private static ChartData add(String title, ChartData chart, Series points, double far) {
        List<Series> series = new ArrayList<>(chart.series());
        List<String> small = new ArrayList<>();
        series.removeIf(line -> Arrays.stream(line.y()).noneMatch(y -> y > SEEN * far) && small.add(line.name()));
        series.add(points);
        return chart.with(List.of(), series).titled(title + (small.isEmpty() ? ""
                : "; outlines of " + SolverChoice.few(small) + " are too small to be seen"));
    }

    /**
     * @param spectrum the spectrum of its start
     * @param finite   the limits of the solvers that have one
     * @return the chart of the growth of the fastest growing mode over deltaT, with the deltaT at which runs began to
     *         grow
     */
    public static ChartData growth(Spectrum spectrum, List<Limit> finite) {
        List<Series> series = new ArrayList<>();
        double largest = finite.stream().mapToDouble(limit -> 2 * limit.measured()).max().orElse(0);
        for (Limit limit : finite) {
            SpectrumLimit theory = new SpectrumLimit(limit.solver().info().orElseThrow(), spectrum);
            List<double[]> line = new ArrayList<>();
            double factor = 1;
            for (int k = 1; k <= POINTS && factor < TOP; k++) {
                double deltaT = largest * k / POINTS;
                double before = factor;
                factor = theory.factor(theory.growingMost(deltaT), deltaT);
                // of the last piece; a refused step grows infinitely, and is drawn where it is refused
                double above = factor > TOP && Double.isFinite(factor) ? (factor - TOP) / (factor - before) : 0;
                line.add(new double[] {deltaT - above * largest / POINTS, Math.min(TOP, factor)});
            }
            series.add(Series.of(limit.solver().label(), Mark.LINE, line));
        }
        series.add(Series.of("limit measured on runs", Mark.OPEN_POINTS, finite, Limit::measured, limit -> 1));
        return new ChartData(finite.stream().map(limit -> limit.solver().label() + " " + Digits.few(limit.measured())
                + " s (" + Digits.few(limit.predicted()) + " s)").collect(Collectors.joining(", ",
                "Longest stable step in runs, predicted in brackets: ", "")), "deltaT (s)",
                "largest factor of a mode in one step", false, false, series);
    }
}
