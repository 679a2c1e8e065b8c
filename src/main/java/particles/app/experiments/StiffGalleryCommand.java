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
                        Two masses swing together on soft springs, with omega = 1. The spring between them is at \
                        rest but for a millionth, and its stiffness k is swept over the decades: what one wants to \
                        see stays the same, and only stability asks for shorter steps. An explicit method is stable \
                        as long as deltaT times omega of the stiff spring stays below its limit, so its cost grows \
                        as the root of the stiffness: the exponent is 0.5.""",
                """
                        Euler, midpoint and adams multiply an undamped vibration in each step, however short it is: \
                        they are never stable, and a result to 1 % is a race between their growth and the end of the \
                        run. What grows by (h omega)^4 / 8 per step, as with midpoint, needs steps as k^(2/3); Euler, \
                        by (h omega)^2 / 2, needs them as k.""",
                """
                        The third chart shows what is left of the energy of the stiff vibration: that is the price \
                        of backward Euler and radau, which wipe it out, and of rk4 close to its limit; implicit \
                        midpoint and verlet keep it. With a step close to their limit, symplectic Euler and yoshida4 \
                        borrow tens to hundreds of times as much and give it back, and the chart has the most that \
                        they borrow; it does not grow, as it does beyond the limit. What adaptive explicit solvers \
                        leave, in the table, is what their tolerance does not see."""),
                List.of(Picture.of("stiff-gallery",
                        """
                        Evaluations for an error of 1 % of the swing after 10 s, evaluations of the cheapest stable \
                        run, and the energy that is left of the stiff vibration, where it does not grow for ever. At \
                        the curves: the exponent with which evaluations grow, from k = 1000 on. Crosses: solvers that \
                        are never stable; rings: a million steps are not enough for 1 %.""",
                        Panel.of(TITLE, StiffCharts.charts(sweeps))).first(SHOWN)),
                List.of(StiffCharts.table(sweeps)));
    }
}
