package particles.app.experiments;

import java.util.List;
import particles.experiments.runs.ProgressListener;
import particles.experiments.work.StiffCloth;
import particles.experiments.work.StiffCloth.Row;
import particles.output.files.OutputFolder;
import particles.output.report.Picture;
import particles.output.report.ResultPage;
import picocli.CommandLine.Command;

/** {@code gradle stiffCloth}: measures the cost of a frame of an ever stiffer cloth. */
@Command(name = "stiffCloth",
        description = "Times a frame of ever stiffer cloth: RK4 against backward Euler with one step a frame.")
public final class StiffClothCommand extends ExperimentCommand {
    @Override
    protected ResultPage measure(OutputFolder folder, ProgressListener progress) {
        List<Row> rows = StiffCloth.measure(StiffCloth.SWEEP, progress);
        return new ResultPage(name(), "One frame of stiff cloth: rk4 against one implicit step", List.of(
                """
                        The stiffer the springs, the more steps of rk4 a frame needs to be stable: as many as the \
                        root of the stiffness. linearised-euler, backward Euler with one linear solve, takes one \
                        step whatever the stiffness; the price of the single step is numerical damping.""",
                "Its first step also orders the equations, once for each cloth. backward-euler iterates to its"
                        + " tolerance; where rk4 needs 100 steps or more, it does not converge."),
                List.of(Picture.of("stiff-cloth", "CPU time of a frame, on logarithmic axes; medians of three"
                        + " steps of linearised-euler.", StiffCloth.panel(rows))),
                List.of(StiffCloth.table(rows)));
    }
}
