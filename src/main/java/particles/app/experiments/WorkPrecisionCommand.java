package particles.app.experiments;

import deSolvers.text.Digits;
import java.util.ArrayList;
import java.util.List;
import particles.experiments.lecture.CostExercise;
import particles.experiments.lecture.CostExercise.Cost;
import particles.experiments.runs.ProgressListener;
import particles.experiments.runs.SolverChoice;
import particles.experiments.work.WorkCharts;
import particles.experiments.work.WorkPrecision;
import particles.experiments.work.WorkPrecision.Curve;
import particles.experiments.work.WorkProblem;
import particles.output.files.OutputFolder;
import particles.output.report.Picture;
import particles.output.report.ResultPage;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** {@code gradle workPrecision}: measures the cost of precision. */
@Command(name = "workPrecision",
        description = "Plots the error of solvers against their cost, on several problems.")
public final class WorkPrecisionCommand extends ExperimentCommand {
    /** The part of the time that the references take. */
    private static final double REFERENCES = 0.02;
    private static final List<String> SHOWN = List.of("euler", "midpoint", "rk4", "dormand-prince", "radau");
    private static final String FAILURES = " Below: the runs without a result.";

    @Option(names = "--problem", paramLabel = "NAMES",
            description = "Problems, separated by commas:"
            + " oscillator, pendulum, kepler, network, stiff-chain, cloth (default: ${DEFAULT-VALUE}).")
    private String problem = "all";

    @Option(names = "--solvers", paramLabel = "NAMES",
            description = "Solvers, separated by commas (default: ${DEFAULT-VALUE}).")
    private String solvers = "all";

    private List<SolverChoice> choices;
    private List<String> names;

    @Override
    protected void read(Mistakes mistakes) {
        mistakes.check(() -> choices = solverChoices(solvers));
        mistakes.check(() -> names = names("problem", "problem", problem, WorkProblem.NAMES));
        super.read(mistakes);
    }

    @Override
    protected ResultPage measure(OutputFolder folder, ProgressListener progress) {
        List<WorkProblem> problems = progress.part(0, REFERENCES).each(names, name -> name + ", the reference",
                WorkProblem::of);
        List<Curve> all = curves(problems, progress.part(REFERENCES, 1));
        List<Picture> pictures = new ArrayList<>();
        for (WorkProblem solved : problems) {
            List<Curve> curves = all.stream().filter(curve -> curve.problem() == solved).toList();
            String caption = solved.title() + " over " + Digits.few(solved.duration()) + " s; reference: "
                    + solved.origin() + ".";
            pictures.add(Picture.of(solved.name() + "-evaluations", caption + " At the curves: the slope of the filled"
                    + " points, and in brackets that of theory." + FAILURES, WorkCharts.byEvaluations(curves))
                    .first(SHOWN));
            pictures.add(Picture.of(solved.name() + "-time", caption
                    + " CPU time in the fastest round, as other work on the machine only makes a round slower; bars go"
                    + " to the median of five. At the curves: the last error." + FAILURES,
                    WorkCharts.byTime(curves)).first(SHOWN));
        }
        progress.reached(1, "the lecture's exercise");
        List<Cost> costs = CostExercise.solve();
        return new ResultPage(name(), "The error of solvers against their cost", List.of("The lecture's exercise, "
                + CostExercise.answer(costs) + ".",
                """
                        Each line is a solver, each point a run with half the step, or a tenth of the tolerance, of \
                        the one before. Its slope is the order, fitted over the filled points: the last three or more \
                        errors in a row below 0.1 and above the last digits that lie on a straight line.""",
                """
                        Explicit solvers have no result on the stiff chain until their step is short enough for the \
                        stiffest spring. Implicit ones take long steps; there radau has the order of its stages, 3, \
                        and not 5."""),
                pictures, List.of(CostExercise.table(costs), WorkCharts.slopes(all), WorkCharts.runs(all)));
    }

    /** All runs take turns, round by round, so that other work on the machine slows down one round of many. */
    private List<Curve> curves(List<WorkProblem> problems, ProgressListener progress) {
        double part = 1.0 / WorkPrecision.ROUNDS;
        List<Curve> curves = progress.part(0, part).parts(problems, (solved, some) -> some.each(choices,
                choice -> choice.label() + " on " + solved.name(), choice ->
                        new WorkPrecision(solved, choice).curve())).stream().flatMap(List::stream).toList();
        for (int round = 1; round < WorkPrecision.ROUNDS; round++) {
            curves = progress.part(part * round, part * (round + 1)).each(curves, curve -> curve.label() + " on "
                    + curve.problem().name(), Curve::timedAgain);
        }
        return curves;
    }
}
