package particles.app.experiments;

import java.util.List;
import particles.experiments.runs.ProgressListener;
import particles.experiments.runs.SolverChoice;
import particles.experiments.work.StiffCharts;
import particles.experiments.work.StiffGallery;
import particles.experiments.work.StiffGallery.Sweep;
import particles.output.files.OutputFolder;
import particles.output.report.Picture;
import particles.output.report.ResultPage;
import particles.view.Panel;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** {@code gradle stiffGallery}: measures the cost of stiffness. */
@Command(name = "stiffGallery",
        description = "Measures what each solver costs as a spring gets stiffer.")
public final class StiffGalleryCommand extends ExperimentCommand {
    private static final String TITLE = "Two masses on an ever stiffer spring";
    private static final List<String> SHOWN = List.of("rk4", "verlet", "backward-euler", "implicit-midpoint", "radau");

    @Option(names = "--solvers", paramLabel = "NAMES",
            description = "Solvers, separated by commas (default: ${DEFAULT-VALUE}).")
    private String solvers = "all";

    @Option(names = "--decades", paramLabel = "NUMBER",
            description = "Decades of stiffness above 1 N/m, 5 to 8 (default: ${DEFAULT-VALUE}).")
    private int decades = 8;

    private List<SolverChoice> choices;

    @Override
    protected void read(Mistakes mistakes) {
        mistakes.check(() -> choices = solverChoices(solvers));
        mistakes.check(() -> requireWithin("decades", decades, 5, 8));
        super.read(mistakes);
    }

    @Override
    protected ResultPage measure(OutputFolder folder, ProgressListener progress) {
        List<Sweep> sweeps = progress.each(choices, SolverChoice::label, choice ->
                StiffGallery.sweep(choice, decades));
        return new ResultPage(name(), TITLE, List.of(
                """
                        Two masses swing together on soft springs, with omega = 1, while the spring between them gets \
                        stiffer: what one wants to see stays the same, and only stability asks for shorter steps. The \
                        cost of an explicit solver grows as the root of the stiffness; implicit ones pay with the \
                        energy of the stiff vibration instead."""),
                List.of(Picture.of("stiff-gallery",
                        """
                        Evaluations for an error of 1 % of the swing after 10 s, evaluations of the cheapest stable \
                        run, and what is left of the energy of the stiff vibration, at most in the last tenth of the \
                        run. At the curves: the exponent with which evaluations grow, from k = 1000 on. Crosses: \
                        solvers that are never stable; rings: a million steps are not enough for 1 %.""",
                        Panel.of(TITLE, StiffCharts.charts(sweeps))).first(SHOWN)),
                List.of(StiffCharts.table(sweeps)));
    }
}
