package particles.experiments.stability;

import deSolvers.text.Digits;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import particles.experiments.runs.SolverChoice;
import particles.experiments.stability.StabilityRegion.Window;
import particles.view.Chart;
import particles.view.Look;
import particles.view.Panel;
import particles.view.Series;
import particles.view.Series.Mark;

/** The chart of a scene's stability: its eigenvalues in the solvers' stability regions. */
public final class SceneStabilityCharts {
    private static final double CELLS = 90;
    /** An outline lower than this part of the chart would be hidden by a mode at 0. */
    private static final double SEEN = 0.05;
    /** At more than so many times the longest stable step, modes are far from all outlines. */
    private static final double FAR_TOO_LONG = 5;

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
    public static Panel plane(String scene, Spectrum spectrum, double deltaT, List<SolverChoice> solvers) {
        double longest = solvers.stream().mapToDouble(solver -> new SpectrumLimit(Amplification.of(solver), spectrum)
                .deltaT()).max().orElse(0);
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
}
