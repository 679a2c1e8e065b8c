package particles.experiments.stability;

import deSolvers.text.Digits;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import particles.experiments.spectrum.Mode;
import particles.experiments.spectrum.Spectrum;
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
    /** Beyond this factor per step is far from safe, and all lines look alike. */
    private static final double TOP = 2;

    private SceneStabilityCharts() {
    }

    /**
     * @param title    the title of the scene
     * @param spectrum the spectrum of its start
     * @param deltaT   the scene's step (s)
     * @param solvers  catalogue names whose outlines are drawn
     * @return the chart of deltaT times each eigenvalue, with the outlines of the regions, and its upper half, which is
     *         the same as the lower one, for a wide page
     */
    public static List<ChartData> plane(String title, Spectrum spectrum, double deltaT, List<String> solvers) {
        List<Double> re = new ArrayList<>();
        List<Double> im = new ArrayList<>();
        double far = 3;
        for (Mode mode : spectrum.modes()) {
            re.add(deltaT * mode.re());
            im.add(deltaT * mode.im());
            far = Math.max(far, 1.1 * deltaT * mode.size());
        }
        Series upper = new Series("deltaT times an eigenvalue of the scene", Mark.POINTS, array(re), array(im));
        re.addAll(re);
        im.addAll(im.stream().map(y -> -y).toList());
        Series both = new Series(upper.name(), Mark.POINTS, array(re), array(im));
        ChartData half = StabilityRegion.half(solvers, new Window(-1.5 * far, far / 2, far, far / CELLS));
        ChartData whole = StabilityRegion.outlines(solvers, new Window(-far, far / 3, far, far / CELLS));
        return List.of(add(whole, both).titled(title), add(half, upper).titled(title));
    }

    private static ChartData add(ChartData chart, Series points) {
        List<Series> series = new ArrayList<>(chart.series());
        series.add(points);
        return chart.with(List.of(), series);
    }

    /**
     * @param spectrum the spectrum of its start
     * @param limits   the limits of the solvers; those without a finite limit are only in the table
     * @return the chart of the growth of the fastest growing mode over deltaT, with the deltaT at which runs began to
     *         grow
     */
    public static ChartData growth(Spectrum spectrum, List<Limit> limits) {
        List<Series> series = new ArrayList<>();
        double largest = 0;
        for (Limit limit : limits) {
            largest = Math.max(largest, isFinite(limit) ? 2 * limit.measured() : 0);
        }
        for (Limit limit : limits) {
            if (isFinite(limit)) {
                SpectrumLimit theory = new SpectrumLimit(Amplification.of(limit.solver().info().orElseThrow()),
                        limit.solver().info().orElseThrow().secondOrder(), spectrum);
                List<Double> x = new ArrayList<>();
                List<Double> y = new ArrayList<>();
                double factor = 1;
                for (int k = 1; k <= POINTS && factor < TOP; k++) {
                    double deltaT = largest * k / POINTS;
                    factor = theory.factor(theory.growingMost(deltaT), deltaT);
                    x.add(deltaT);
                    y.add(Math.min(TOP, factor));
                }
                series.add(new Series(limit.solver().label(), Mark.LINE, array(x), array(y)));
                series.add(Series.point(limit.solver().label() + ", runs: " + Digits.few(limit.measured()) + " s",
                        Mark.POINTS, limit.measured(), 1));
            }
        }
        return new ChartData(drawn -> "Runs move apart from deltaT = " + limits.stream()
                .filter(limit -> isFinite(limit) && limit.solver().isIn(drawn))
                .map(limit -> Digits.few(limit.measured()) + " s (" + limit.solver().label() + ")")
                .collect(Collectors.joining(", ")) + " on", "deltaT (s)", "largest factor of a mode in one step", false,
                false, series);
    }

    private static boolean isFinite(Limit limit) {
        return limit.measured() > 0 && limit.measured() < Double.POSITIVE_INFINITY && !limit.solver().adaptive()
                && limit.predicted() > 0 && limit.predicted() < Double.POSITIVE_INFINITY;
    }

    private static double[] array(List<Double> values) {
        return values.stream().mapToDouble(Double::doubleValue).toArray();
    }
}
