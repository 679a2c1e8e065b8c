package particles.experiments.stability;

import deSolvers.catalog.SolverInfo;
import deSolvers.text.Digits;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import particles.experiments.stability.SceneStability.Limit;
import particles.experiments.stability.StabilityRegion.Window;
import particles.view.Axis;
import particles.view.Chart;
import particles.view.Look;
import particles.view.Panel;
import particles.view.Series;
import particles.view.Series.Mark;

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
     * @param solvers  the solvers whose outlines are drawn
     * @return the step times each eigenvalue, with the outlines of the regions that are large enough to be seen; where
     *         the scene's step is far too long for all solvers, it is drawn at the longest that is stable with one
     */
    public static Panel plane(String scene, Spectrum spectrum, double deltaT, List<SolverInfo> solvers) {
        double longest = solvers.stream().mapToDouble(solver -> new SpectrumLimit(solver, spectrum).deltaT()).max()
                .orElse(0);
        double step = longest > 0 && deltaT > FAR_TOO_LONG * longest ? longest : deltaT;
        List<double[]> points = spectrum.modes().stream().flatMap(mode -> Stream.of(mode.im(), -mode.im()).map(im ->
                new double[] {step * mode.re(), step * im})).toList();
        double far = spectrum.modes().stream().mapToDouble(mode -> 1.1 * step * mode.size()).reduce(3, Math::max);
        Chart outlines = StabilityRegion.outlines(solvers, new Window(-far, far / 3, -far, far, far / CELLS));
        List<Series> series = new ArrayList<>(outlines.series());
        series.removeIf(line -> Arrays.stream(line.y()).noneMatch(y -> y > SEEN * far));
        series.add(Series.of(Look.number(0), "modes of the scene", Mark.POINTS, points));
        return Panel.map(scene + ": eigenvalues times deltaT = " + Digits.few(step) + " s",
                new Chart(outlines.x(), outlines.y(), series).scaledTo(outlines.scale()));
    }

    /**
     * @param spectrum the spectrum of its start
     * @param finite   the limits of the solvers that have one
     * @return the chart of the growth of the fastest growing mode over deltaT, with the deltaT at which runs began to
     *         grow
     */
    public static Chart growth(Spectrum spectrum, List<Limit> finite) {
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
            series.add(Series.of(limit.solver().look(), limit.solver().label(), Mark.LINE, line)
                    .ending(Digits.few(limit.measured()) + " s"));
            series.add(Series.point(limit.solver().look(), "longest stable step in runs", Mark.OPEN_POINTS,
                    limit.measured(), 1));
        }
        return new Chart(Axis.linear("deltaT", "s"), Axis.linear("largest factor of a mode in one step", ""), series);
    }
}
