package particles.app.experiments;

import java.util.List;
import particles.experiments.energy.DriftCharts;
import particles.experiments.energy.EnergyDrift;
import particles.experiments.energy.EnergyDrift.Comparison;
import particles.experiments.runs.ProgressListener;
import particles.output.files.OutputFolder;
import particles.output.report.Picture;
import particles.output.report.ResultPage;
import particles.view.Panel;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code gradle energyDrift}: compares the energy drift of solvers on a scene. */
@Command(name = "energyDrift", description = "Compares how well solvers keep the energy of a scene.")
public final class EnergyDriftCommand extends ExperimentCommand {
    private static final List<String> SHOWN = List.of("euler", "midpoint", "rk4", "verlet", "implicit-midpoint");

    @Mixin
    private final SceneOptions options = new SceneOptions();

    @Option(names = "--equalWork", arity = "0..1",
            paramLabel = "true|false",
            description =
            "Equal evaluations, as many as rk4 needs, instead of equal deltaT (default: ${DEFAULT-VALUE}).")
    private boolean equalWork;

    @Override
    protected void read(Mistakes mistakes) {
        options.read(mistakes, this, "undamped-net", "all");
        super.read(mistakes);
    }

    @Override
    protected ResultPage measure(OutputFolder folder, ProgressListener progress) {
        Comparison comparison = EnergyDrift.compare(options.scene(), options.solvers(), equalWork, progress);
        String title = DriftCharts.title(comparison);
        return new ResultPage(name(), title, List.of(
                """
                        The energy error is the change of the total energy minus the work of drag, damping, wind, \
                        contacts and collisions: the solver's own error, divided by the largest kinetic plus stored \
                        energy of the run.""",
                """
                        It drifts if the straight line through it rises by more than twice the scatter about it and \
                        it still grows in the second half, or ends at its largest; otherwise it is bounded. Where \
                        damping, driving or impacts change the energy, only its size compares solvers."""),
                List.of(Picture.of("energy-drift", """
                        The size of the energy error over time. At the curves: an error that drifts, at the end; the \
                        largest size of any other. A cross marks a run that ended early.""",
                        Panel.of(title, List.of(DriftCharts.sizes(comparison)))).first(SHOWN),
                        Picture.of("energy-drift-energy-error",
                                "The energy error over time, while it is less than 10 %.",
                                Panel.of(title + ", with its sign", List.of(DriftCharts.small(comparison))))
                                .first(SHOWN)),
                List.of(DriftCharts.table(comparison)));
    }
}
