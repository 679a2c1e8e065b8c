package particles.app.experiments;

import static particles.view.DataTable.column;

import deSolvers.text.Digits;
import java.util.ArrayList;
import java.util.List;
import particles.experiments.runs.ProgressListener;
import particles.experiments.runs.SolverChoice;
import particles.experiments.spectrum.Spectrum;
import particles.experiments.spectrum.Spectrum.Mode;
import particles.experiments.stability.SceneStability;
import particles.experiments.stability.SceneStability.Limit;
import particles.experiments.stability.SceneStabilityCharts;
import particles.output.charts.Panel;
import particles.output.report.Picture;
import particles.output.report.ResultPage;
import particles.scene.format.SceneDescription;
import particles.view.ChartData;
import particles.view.DataTable;

/** The page of {@code gradle stability -Pscene}: the longest stable step of each solver in this scene. */
final class SceneStabilityPage {
    private static final String NAME = "stability";
    private static final int MOST_MODES = 12;
    /** The solvers whose regions are drawn by default. */
    private static final List<String> OUTLINES = List.of("euler", "midpoint", "rk4", "symplectic-euler", "verlet");

    private SceneStabilityPage() {
    }

    /** @return the page of a scene with at least one mode that does not grow by itself */
    static ResultPage measure(SceneDescription scene, Spectrum spectrum, List<SolverChoice> solvers,
            ProgressListener progress) {
        Mode fastest = spectrum.decaying().get(0);
        List<Limit> limits = SceneStability.measure(scene, spectrum, solvers, progress.part(0, 0.9));
        progress.reached(0.9, "outlines of the regions");
        List<String> outlined = solvers.size() == 1
                ? solvers.stream().filter(solver -> solver.info().isPresent()).map(SolverChoice::name)
                .toList() : OUTLINES;
        List<Picture> pictures = new ArrayList<>();
        List<ChartData> plane = SceneStabilityCharts.plane(scene.title()
                + ": the fastest mode lies at deltaT |lambda| = " + Digits.few(scene.deltaT() * fastest.size()),
                spectrum, scene.deltaT(), outlined);
        String caption = """
                Each point is deltaT times an eigenvalue of the scene's linearised start: the fastest, and what else \
                the iteration found. A step is safe where all points to the left of the imaginary axis, or on it, \
                lie inside the solver's outline.""";
        pictures.add(Picture.of("eigenvalues", caption, Panel.map(plane.get(0))).onSlides(List.of(
                Picture.of("eigenvalues", caption, Panel.map(plane.get(1))))));
        List<Limit> finite = limits.stream().filter(Limit::isFinite).toList();
        if (!finite.isEmpty()) {
            pictures.add(Picture.bySolver("growth",
                    "Lines: the largest factor of any mode in one step, as predicted; they end at 2."
                    + " Points: the step at which pairs of runs began to move apart, by bisection.",
                    finite, limit -> limit.solver().label(),
                    some -> List.of(SceneStabilityCharts.growth(spectrum, some))));
        }
        return new ResultPage(NAME, title(scene, limits, fastest), text(spectrum, fastest), pictures,
                List.of(SceneStability.table(limits, scene.deltaT()), modes(spectrum)));
    }

    private static String title(SceneDescription scene, List<Limit> limits, Mode fastest) {
        String limit = limits.stream().filter(known -> Limit.isFinite(known.measured())).findFirst()
                .map(known -> Digits.format(", and %s is stable with steps up to deltaT = %.3g s",
                        known.solver().label(), known.predicted() > 0
                        ? Math.min(known.predicted(), known.measured()) : known.measured()))
                .orElse("");
        return Digits.format("%s: the fastest mode has |lambda| = %.3g /s%s", scene.title(),
                fastest.size(), limit);
    }

    private static List<String> text(Spectrum spectrum, Mode fastest) {
        String grows = spectrum.growth() == 0 ? ""
                : Digits.format(" Some motion grows by itself, by %.3g /s: that is physics, not an"
                        + " error of the solver.", spectrum.growth());
        return List.of(Digits.format("""
                        Predicted: the scene's equations, linearised at its start, have modes with eigenvalues up to \
                        |lambda| = %.8g /s (%d products with the Jacobian, relative error below %.0e). The \
                        longest safe step is the one at which the solver's own factor of some mode exceeds 1. A mode \
                        counts even if the scene does not excite it, such as the sideways swing of a stretched \
                        spring.%s""", fastest.size(),
                        spectrum.products(), Math.max(1e-15, spectrum.error()), grows),
                """
                        Measured: two runs of the whole scene, rules included, begin a ten-millionth of its size \
                        apart. A step is unsafe if 512 of them bring the runs 20 times farther apart than the motion \
                        itself does, as very short steps show it, or if a run fails; the limit is bisected to 2e-3 \
                        of it. Growth, too, is counted over that of the motion itself. What grows by less than 0.6 % \
                        a step is not seen in 512 steps, so that euler's limit comes out a little large. Both agree \
                        as long as the scene stays near its start. If springs turn, stretch or hit something, the \
                        spectrum changes; then trust the runs.""",
                """
                        An adaptive solver divides a deltaT that is too long; its longest stable sub-step is given. \
                        Implicit solvers were run with steps of up to 1800/|lambda|, some 640 times rk4's limit, \
                        where they are stable, not accurate.""");
    }

    private static DataTable modes(Spectrum spectrum) {
        return DataTable.of("modes", "The fastest modes of the scene's start",
                spectrum.modes().subList(0, Math.min(MOST_MODES, spectrum.modes().size())),
                column("Re lambda (1/s)", 6, Mode::re), column("Im lambda (1/s)", 6, Mode::im),
                column("period (s)", mode -> mode.im() == 0 ? Double.POSITIVE_INFINITY : 2 * Math.PI / mode.im()));
    }
}
