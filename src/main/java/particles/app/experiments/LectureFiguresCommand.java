package particles.app.experiments;

import deSolvers.catalog.SolverCatalog;
import deSolvers.text.Digits;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import particles.experiments.lecture.LectureFigures;
import particles.experiments.lecture.LectureFigures.Figure;
import particles.experiments.lecture.LectureFigures.Result;
import particles.experiments.runs.ProgressListener;
import particles.output.files.OutputFolder;
import particles.output.report.Picture;
import particles.output.report.ResultPage;
import particles.view.Panel;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** {@code gradle lectureFigures}: the slides' figures, from their captions. */
@Command(name = "lectureFigures",
        description = "Draws the figures of the lecture: Euler, midpoint and RK4 over the vector field.")
public final class LectureFiguresCommand extends ExperimentCommand {
    private static final int MOST_STEPS = 200_000;
    private static final double DELTA_T = 0.4;
    private static final int STEPS = 100;

    @Option(names = "--solver", paramLabel = "NAME", description = "Adds a figure with this solver.")
    private String solver;

    @Option(names = "--deltaT", paramLabel = "SECONDS",
            description = "Its time step (default: " + DELTA_T + "; one period is 6.283 s).")
    private Double deltaT;

    @Option(names = "--steps", paramLabel = "NUMBER", description = "Its steps (default: " + STEPS + ").")
    private Integer steps;

    @Override
    protected void read(Mistakes mistakes) {
        if (deltaT != null) {                           // picocli leaves an option null that was not given
            mistakes.check(() -> {
                if (!(deltaT > 0 && Double.isFinite(deltaT))) {
                    throw wrong("deltaT", deltaT + " has to be finite and more than 0");
                }
                requireSolver("deltaT");
            });
        }
        if (steps != null) {
            mistakes.check(() -> {
                requireWithin("steps", steps, 1, MOST_STEPS);
                requireSolver("steps");
            });
        }
        if (solver != null) {
            mistakes.check(() -> made("solver", () -> SolverCatalog.info(solver)));
        }
        super.read(mistakes);
    }

    private void requireSolver(String option) {
        if (solver == null) {
            throw wrong(option,
                    "needs " + getStyle().option("solver") + "; the slides' figures have their own values");
        }
    }

    @Override
    protected ResultPage measure(OutputFolder folder, ProgressListener progress) {
        List<Figure> figures = new ArrayList<>(LectureFigures.ON_SLIDES);
        if (solver != null) {
            figures.add(new Figure(solver, deltaT == null ? DELTA_T : deltaT, steps == null ? STEPS : steps));
        }
        List<Result> results = progress.each(figures, Figure::solver, LectureFigures::run);
        Panel alone = Panel.phase("The vector field (v, \u2212x)", LectureFigures.exactChart(),
                Optional.of(LectureFigures.field(1.5))).answered("each solution is a circle");
        List<Panel> panels = new ArrayList<>(List.of(alone));
        List<Picture> pictures = new ArrayList<>(List.of(Picture.of("vector-field",
                "The vector field of x'' = -x, and the one solution through (1, 0).", alone).again()));
        for (Result result : results) {
            Panel panel = Panel.phase(title(result.figure()), LectureFigures.chart(result),
                    Optional.of(LectureFigures.field(LectureFigures.reach(result)))).answered(answer(result));
            panels.add(panel);
            pictures.add(Picture.of(fileName(result.figure()), panel.title() + ".", panel).again());
        }
        String title = "The slides' figures: x'' = \u2212x in state space";
        pictures.add(0, Picture.panels("all-figures", "All figures beside each other; each has its own scale.", title,
                panels));
        return new ResultPage(name(), title, List.of("""
                        The oscillator x'' = -x from (1, 0): the exact solution is the dashed circle, clockwise in \
                        2 pi s. N steps of h multiply the amplitude by |R(ih)|^N and run ahead of the exact phase by \
                        N (arg R - h), where R is the method's stability function."""),
                pictures, List.of(LectureFigures.table(results)));
    }

    private static String title(Figure figure) {
        return figure.solver() + ", deltaT = " + Digits.exact(figure.deltaT()) + " s, " + figure.steps() + " steps";
    }

    private static String answer(Result result) {
        return Digits.format("amplitude \u00d7 %.4g, phase %+.3g rad", result.amplitude(), result.phaseError());
    }

    private static String fileName(Figure figure) {
        return figure.solver() + "-" + Digits.exact(figure.deltaT()) + "s-"
                + figure.steps() + "-steps";
    }
}
