package particles.app.experiments;

import static particles.view.DataTable.column;

import deSolvers.catalog.SolverCatalog;
import deSolvers.text.Digits;
import java.util.Comparator;
import java.util.List;
import particles.app.experiments.Experiment.Run;
import particles.experiments.runs.SolverChoice;
import particles.experiments.stability.SceneStability;
import particles.experiments.stability.SceneStabilityCharts;
import particles.experiments.stability.Spectrum;
import particles.experiments.stability.Spectrum.Mode;
import particles.experiments.stability.StabilityLimit;
import particles.experiments.stability.StabilityRegion;
import particles.experiments.stability.StabilityRegion.Window;
import particles.output.report.Picture;
import particles.scene.format.SceneDescription;
import particles.view.DataTable;
import particles.view.Panel;

/** The longest stable step, on every solver's real code or in one scene. */
final class StabilityExperiment {
    private static final int MOST_MODES = 12;
    /** Of many solvers the outlines of these are drawn, or of others until there are as many. */
    private static final List<String> OUTLINES = List.of("euler", "midpoint", "rk4", "symplectic-euler", "verlet");

    private static final List<Region> REGIONS = List.of(
            new Region("slides", """
                    Stable in the shaded region. Of the imaginary axis, only 0 belongs \
                    to the regions of euler, midpoint and adams: at 0.8, a step of adams grows by 0.7 %.""",
                    List.of("euler", "midpoint", "rk4", "adams"), new Window(-3.5, 1, -3.5, 3.5, 0.05)),
            new Region("adaptive", "One sub-step. Longer steps are divided: the outlines show the cost of a stiff"
                    + " system.", List.of("step-doubling", "dormand-prince", "bulirsch-stoer"),
                    new Window(-8, 2.5, -6.5, 6.5, 0.08)),
            new Region("symplectic", "A damped spring. Without damping, on the imaginary axis, the limit is 2 (1.57 for"
                    + " yoshida4); damping lowers it.", List.of("symplectic-euler", "verlet", "yoshida4"),
                    new Window(-2.5, 1, -2.5, 2.5, 0.04)),
            new Region("implicit", "Stable left of the outline of implicit-midpoint, the imaginary axis, and outside"
                    + " the others, which also damp fast growth. Beyond the frame the regions go on.",
                    List.of("backward-euler", "implicit-midpoint", "radau"), new Window(-3, 13, -8, 8, 0.15)));

    private StabilityExperiment() {
    }

    static Run plan(DeclaredCommand asked) {
        if (!asked.hasScene()) {
            return limits(asked);
        }
        Spectrum spectrum = SceneStability.spectrum(asked.scene());
        if (spectrum.decaying().isEmpty()) {
            throw asked.wrong("scene", "this scene has no vibration or damping at its start that limits a step; choose"
                    + " a scene with springs, drag or rods between free particles");
        }
        return inScene(asked, spectrum);
    }

    private static Run limits(DeclaredCommand asked) {
        return (folder, progress) -> {
            DataTable limits = StabilityLimit.table(asked.solvers(), progress.part(0, 0.5));
            return asked.page("Stability limits, measured",
                    progress.part(0.5, 1).each(REGIONS.stream().map(region -> region.of(asked.solvers()))
                            .filter(region -> !region.solvers().isEmpty()).toList(), Region::name, Region::draw),
                    List.of(limits));
        };
    }

    /** The longest stable step of each solver in a scene with at least one mode that does not grow by itself. */
    private static Run inScene(DeclaredCommand asked, Spectrum spectrum) {
        SceneDescription scene = asked.scene();
        List<SolverChoice> outlined = asked.solvers().stream().sorted(Comparator.comparing(one ->
                one.info().isPresent() && !OUTLINES.contains(one.name()))).limit(OUTLINES.size()).toList();
        return (folder, progress) -> asked.page(scene.title() + ": longest stable step, fastest mode |lambda| = "
                + Digits.few(spectrum.decaying().get(0).size()) + " /s",
                List.of(Picture.of("eigenvalues", """
                        Each point is the step times an eigenvalue of the equations, linearised at the start. A step \
                        is safe where all points to the left of the imaginary axis, or on it, lie where the solver is \
                        stable: inside the outline of an explicit one, and outside or left of an implicit one's. An \
                        outline that is too small to be seen here is left out.""",
                        SceneStabilityCharts.plane(scene.title(), spectrum, scene.deltaT(), outlined))),
                List.of(SceneStability.table(SceneStability.limits(scene, spectrum, asked.solvers(), progress),
                        scene.deltaT()), modes(spectrum)));
    }

    private static DataTable modes(Spectrum spectrum) {
        return DataTable.of("modes", "The fastest modes of the scene's start",
                spectrum.modes().subList(0, Math.min(MOST_MODES, spectrum.modes().size())),
                column("Re lambda (1/s)", 6, Mode::re), column("Im lambda (1/s)", 6, Mode::im),
                column("period (s)", mode -> mode.im() == 0 ? Double.POSITIVE_INFINITY : 2 * Math.PI / mode.im()));
    }

    /** A picture of stability regions: its name and caption, and the solvers shown in a part of the plane. */
    private record Region(String name, String caption, List<String> solvers, Window window) {
        /** The same picture with some of its solvers. */
        Region of(List<SolverChoice> some) {
            return new Region(name, caption, solvers.stream().filter(solver -> some.stream().anyMatch(one ->
                    one.name().equals(solver))).toList(), window);
        }

        Picture draw() {
            List<Panel> panels = solvers.stream().map(solver -> StabilityRegion.filled(SolverCatalog.info(solver),
                    window)).toList();
            return Picture.panels("region-" + name, caption, "Stability regions, measured", panels.stream().map(panel ->
                    panel.with(panel.title(), List.of(panel.charts().get(0).scaledTo(panels.get(0).charts().get(0)
                            .scale())))).toList());
        }
    }
}
