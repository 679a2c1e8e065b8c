package particles.app;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.NoSuchElementException;
import particles.DataTable;
import particles.experiments.CostExercise;
import particles.experiments.ProgressListener;
import particles.experiments.SolverChoice;
import particles.experiments.WorkCharts;
import particles.experiments.WorkPrecision;
import particles.experiments.WorkPrecision.Curve;
import particles.experiments.problems.WorkProblem;
import particles.experiments.problems.WorkProblems;
import particles.output.OutputFolder;
import particles.output.ResultPage;
import particles.output.ResultPage.Picture;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** {@code gradle workPrecision}: what precision costs. */
@Command(name = WorkPrecisionCommand.NAME, description = "Sets the error of solvers against their cost, on several problems.")
final class WorkPrecisionCommand extends ExperimentCommand {
    static final String NAME = "workPrecision";

    @Option(names = "--problem", paramLabel = "NAMES", defaultValue = "all", description = "Problems, separated by commas:"
            + " oscillator, pendulum, kepler, network, stiff-chain, cloth (default: ${DEFAULT-VALUE}).")
    private String problem = "all";

    @Option(names = "--solvers", paramLabel = "NAMES", defaultValue = "all",
            description = "Solvers, separated by commas (default: ${DEFAULT-VALUE}).")
    private String solvers = "all";

    WorkPrecisionCommand(OptionStyle style) {
        super(style);
    }

    @Override
    String name() {
        return NAME;
    }

    @Override
    void check() {
        chosen();
        for (String name : names()) {
            if (!WorkProblems.NAMES.contains(name)) {
                try {
                    WorkProblems.of(name);
                } catch (NoSuchElementException e) {
                    throw wrong("problem", e.getMessage());
                }
            }
        }
    }

    private List<String> names() {
        List<String> names = problem.strip().equals("all") ? WorkProblems.NAMES
                : Arrays.stream(problem.split(",")).map(String::strip).filter(name -> !name.isEmpty()).distinct().toList();
        if (names.isEmpty()) {
            throw wrong("problem", "no problem is named; known: " + String.join(", ", WorkProblems.NAMES));
        }
        return names;
    }

    private List<SolverChoice> chosen() {
        try {
            return SolverChoice.list(solvers);
        } catch (NoSuchElementException | IllegalArgumentException e) {
            throw wrong("solvers", e.getMessage());
        }
    }

    @Override
    ResultPage measure(OutputFolder folder, ProgressListener progress) {
        Map<WorkProblem, List<Curve>> all = new LinkedHashMap<>();
        List<String> names = names();
        List<SolverChoice> choices = chosen();
        for (String name : names) {
            progress.reached((double) all.size() / names.size(), name + ", the reference");
            WorkProblem solved = WorkProblems.of(name);
            List<Curve> curves = new ArrayList<>();
            for (SolverChoice choice : choices) {
                progress.reached((all.size() + (double) curves.size() / choices.size()) / names.size(), choice.label() + " on " + name);
                curves.add(WorkPrecision.measure(solved, choice));
            }
            all.put(solved, curves);
        }
        List<Picture> pictures = new ArrayList<>();
        all.forEach((solved, curves) -> {
            String caption = solved.title() + " over " + Digits.few(solved.duration()) + " s; reference: " + solved.origin()
                    + ". Crosses are runs without a result.";
            pictures.add(Picture.chart(solved.name() + "-evaluations", caption, WorkCharts.byEvaluations(solved, curves)));
            pictures.add(Picture.chart(solved.name() + "-time", caption, WorkCharts.byTime(solved, curves)));
        });
        DataTable exercise = CostExercise.table(CostExercise.solve());
        return new ResultPage(NAME, "Higher order pays the more, the more precision is asked: RK4 costs a quarter of midpoint for an"
                + " error of 0.1, and a 67th for one in a million", List.of(
                "Each line is a solver, each point a run with half the step, or a tenth of the tolerance, of the one before. Its slope"
                        + " is the order: with half the step, the error of rk4 falls to a sixteenth. The slope is fitted to the last three"
                        + " errors between 3e-11 and 0.1.",
                "On the stiff chain the explicit methods have no result until their step is short enough for the stiffest spring,"
                        + " and the implicit ones may fall short of their order there, since the stages see the stiff forces; the table has"
                        + " slope and order side by side."),
                pictures, List.of(exercise, WorkCharts.slopes(all), WorkCharts.runs(all)));
    }
}
