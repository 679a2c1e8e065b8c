package particles.app.experiments;

import java.util.List;
import java.util.function.Supplier;
import particles.experiments.runs.ProgressListener;
import particles.experiments.runs.SolverChoice;
import particles.experiments.spectrum.Spectrum;
import particles.experiments.stability.SceneStability;
import particles.experiments.stability.StabilityLimit;
import particles.experiments.stability.StabilityRegion;
import particles.experiments.stability.StabilityRegion.Window;
import particles.output.charts.Panel;
import particles.output.files.OutputFolder;
import particles.output.report.Picture;
import particles.output.report.ResultPage;
import particles.scene.Overrides;
import particles.scene.format.SceneDescription;
import particles.view.DataTable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** {@code gradle stability}: measures the longest stable step, on every solver's real code or in one scene. */
@Command(name = "stability", description = "Measures the longest stable step of each solver.")
public final class StabilityCommand extends ExperimentCommand {
    @Option(names = "--scene", paramLabel = "NAME",
            description = "Finds the longest step in this scene: a file, or the name or number of one in scenes"
                    + " (default: each solver by itself).")
    private String scene = "";

    @Option(names = "--solvers", paramLabel = "NAMES",
            description = "Solvers to try in the scene, separated by commas (default: all).")
    private String solvers;

    @Option(names = "--deltaT", paramLabel = "SECONDS",
            description = "The step at which growth is reported, instead of the scene's.")
    private String deltaT;

    private Supplier<List<SolverChoice>> choices;
    private Supplier<SceneDescription> description;
    private Supplier<Spectrum> spectrum;

    @Override
    protected void read(Mistakes mistakes) {
        mistakes.check(() -> requireScene("solvers", solvers));
        mistakes.check(() -> requireScene("deltaT", deltaT));
        choices = mistakes.value(() -> solverChoices(solvers == null ? "all" : solvers));
        if (!scene.isEmpty()) {
            Overrides overrides = new Overrides(getStyle()::option).with("deltaT", deltaT);
            description = mistakes.value(() -> overrides.applyTo(SceneOptions.read(scene)));
            spectrum = mistakes.value(this::readSpectrum);
        }
        super.read(mistakes);
    }

    private void requireScene(String option, String value) {
        if (scene.isEmpty() && value != null) {              // picocli leaves an option null that was not given
            throw wrong(option, "goes with " + getStyle().option("scene") + " only");
        }
    }

    private Spectrum readSpectrum() {
        Spectrum found = SceneStability.spectrum(description.get());
        if (found.decaying().isEmpty()) {
            throw wrong("scene", "this scene has no vibration or damping at its start that limits a step; choose a"
                    + " scene with springs, drag or rods between free particles");
        }
        return found;
    }

    @Override
    protected ResultPage measure(OutputFolder folder, ProgressListener progress) {
        return scene.isEmpty() ? limits(progress)
                : SceneStabilityPage.measure(description.get(), spectrum.get(), choices.get(), progress);
    }

    private ResultPage limits(ProgressListener progress) {
        DataTable limits = StabilityLimit.table((part, what) -> progress.reached(part / 2, what));
        return new ResultPage(name(), StabilityLimit.finding(), List.of(
                """
                        Every number was measured on the solver's code, by bisection on the test equation y' = \
                        lambda y. Beside it is the theory, as in the catalogue. A spring without damping lies on the \
                        imaginary axis, lambda = i omega; pure decay lies on the negative real axis.""",
                """
                        An adaptive solver makes its sub-steps shorter before anything grows. With an unlimited \
                        tolerance it takes one sub-step of deltaT; that sub-step is measured. Beyond its limit it \
                        has to take more sub-steps, and that is what a stiff system costs it. bulirsch-stoer states \
                        no limits, as every number of lines of its table has its own; measured are those with which \
                        it begins.""",
                """
                        Symplectic solvers need positions and velocities: what is measured is a damped spring with \
                        the eigenvalues lambda and its conjugate, on the real axis the critically damped one. verlet \
                        and yoshida4 refuse a step whose last kick they cannot solve; that counts as unstable, and \
                        with strong damping it is their limit."""),
                List.of(new Region("slides",
                                """
                                The slides' solvers and adams; stable in the shaded region. Of the imaginary axis, \
                                only 0 belongs to the regions of euler, midpoint and adams; the outline of adams runs \
                                so close beside the axis, up to 0.9, that the picture cannot show it: at 0.8 a step \
                                still grows by 0.7 %.""",
                                List.of("euler", "midpoint", "rk4", "adams"), new Window(-3.5, 1, -3.5, 3.5, 0.05), 4.7)
                                        .draw(progress, 0.5),
                        new Region("adaptive",
                                "One sub-step. Longer steps are divided, so these"
                                        + " outlines show the cost of a stiff system.",
                                List.of("step-doubling", "dormand-prince", "bulirsch-stoer"),
                                new Window(-8, 2.5, -6.5, 6.5, 0.08), 8.5).draw(progress, 0.6),
                        new Region("symplectic",
                                "A damped spring. Without damping, on the imaginary axis, the limit is 2 (1.57 for"
                                        + " yoshida4); damping lowers it.",
                                List.of("symplectic-euler", "verlet", "yoshida4"),
                                new Window(-2.5, 1, -2.5, 2.5, 0.04), 3).draw(progress, 0.7),
                        new Region("implicit",
                                """
                                        Stable in the shaded region: left of the outline of implicit-midpoint, the \
                                        imaginary axis, which reproduces growth as growth and decay as decay, and \
                                        outside the others, which also damp growth, if it is fast. Beyond the frame \
                                        the regions go on.""",
                                List.of("backward-euler", "implicit-midpoint", "radau"),
                                new Window(-3, 13, -8, 8, 0.15), 3).draw(progress, 0.85)),
                List.of(limits));
    }

    /**
     * A picture of stability regions: its name and caption, the solvers shown in a part of the plane, and how far the
     * plane reaches to the left on a slide, which is wide and shows its upper half.
     */
    private record Region(String name, String caption, List<String> solvers, Window window, double left) {
        Picture draw(ProgressListener progress, double done) {
            progress.reached(done, "regions of " + String.join(", ", solvers));
            Window wide = new Window(-left, window.right(), 0, window.top(), window.cell());
            String file = "region-" + name;
            List<Panel> panels = solvers.stream().map(solver -> Panel.map(StabilityRegion.filled(solver, window)))
                    .toList();
            return Picture.panels(file, caption, StabilityRegion.finding(solvers, window),
                    panels.stream().map(panel -> panel.scaledTo(panels)).toList())
                    .onSlides(List.of(Picture.of(file, caption,
                            Panel.map(StabilityRegion.filled(solvers, wide)))));
        }
    }
}
