package particles.experiments.stability;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
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
    /** Beyond this factor a step is far from safe, and all lines look alike. */
    private static final double TOP = 2;

    private SceneStabilityCharts() {
    }

    /**
     * @param title    the title of the scene
     * @param spectrum the spectrum of its start
     * @param deltaT   the scene's step (s)
     * @param solvers  catalogue names whose outlines are drawn
     * @return the chart of deltaT times each eigenvalue, with the outlines of the regions
     */
    public static ChartData plane(String title, Spectrum spectrum, double deltaT, List<String> solvers) {
        List<Double> re = new ArrayList<>();
        List<Double> im = new ArrayList<>();
        double far = 3;
        for (Mode mode : spectrum.modes()) {
            for (int sign = 1; sign >= -1; sign -= 2) {
                re.add(deltaT * mode.re());
                im.add(sign * deltaT * mode.im());
            }
            far = Math.max(far, 1.1 * deltaT * mode.size());
        }
        ChartData outlines = StabilityRegion.outlines(title, solvers, new Window(-far, far / 3, far, far / CELLS));
        List<Series> series = new ArrayList<>(outlines.series());
        series.add(new Series("deltaT times an eigenvalue of the scene", Mark.POINTS, array(re), array(im)));
        return new ChartData(title, outlines.xLabel(), outlines.yLabel(), false, false, series);
    }

    /**
     * @param title    the title of the scene
     * @param spectrum the spectrum of its start
     * @param limits   the limits of the solvers; those without a finite limit are only in the table
     * @return the chart of the growth of the fastest growing mode over deltaT, with the deltaT at which runs began to
     *         grow
     */
    public static ChartData growth(String title, Spectrum spectrum, List<Limit> limits) {
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
                series.add(new Series(limit.solver().label() + ", spectrum", Mark.LINE, array(x), array(y)));
                series.add(new Series(limit.solver().label() + String.format(Locale.ROOT, ", run: %.4g s",
                        limit.measured()), Mark.POINTS,
                        new double[] {limit.measured()}, new double[] {1}));
            }
        }
        return new ChartData(title, "deltaT (s)", "largest factor of a mode in one step", false, false, series);
    }

    private static boolean isFinite(Limit limit) {
        return limit.measured() > 0 && limit.measured() < Double.POSITIVE_INFINITY && !limit.solver().adaptive()
                && limit.predicted() > 0 && limit.predicted() < Double.POSITIVE_INFINITY;
    }

    private static double[] array(List<Double> values) {
        return values.stream().mapToDouble(Double::doubleValue).toArray();
    }
}
