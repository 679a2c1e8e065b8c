package particles.app.experiments;

import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import particles.app.experiments.Experiment.Choice;
import particles.app.experiments.Experiment.Run;
import particles.experiments.runs.ProgressListener;
import particles.experiments.work.WorkProblem;
import particles.output.files.OutputFolder;
import particles.output.report.Picture;
import particles.output.report.ResultPage;
import particles.view.DataTable;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** The command of a declared experiment. */
public final class DeclaredCommand extends ExperimentCommand {
    private static final int MOST_FRAMES = 2000;
    private static final int MOST_COLUMNS = 500;

    private final Experiment experiment;

    @Mixin
    final SceneOptions options = new SceneOptions();

    @Option(names = "--equalWork", arity = "0..1", paramLabel = "true|false", description =
            "Equal evaluations, as many as rk4 needs, instead of equal deltaT (default: ${DEFAULT-VALUE}).")
    boolean equalWork;

    @Option(names = "--frames", paramLabel = "NUMBER", description = "Frames of the animation, which shows 20 per"
            + " second (default: 20 per second of the scene, 40 to 300).")
    Optional<Integer> frames = Optional.empty();

    @Option(names = "--problem", paramLabel = "NAMES", description = "Problems, separated by commas:"
            + " oscillator, pendulum, kepler, network, stiff-chain, cloth (default: ${DEFAULT-VALUE}).")
    private String problem = "all";

    @Option(names = "--decades", paramLabel = "NUMBER",
            description = "Decades of stiffness above 1 N/m, 5 to 8 (default: ${DEFAULT-VALUE}).")
    int decades = 8;

    @Option(names = "--columns", paramLabel = "NUMBER",
            description = "The number of columns and of rows of the cloth (default: ${DEFAULT-VALUE}).")
    int columns = 40;

    @Option(names = "--rounds", paramLabel = "NUMBER",
            description = "The number of rounds, each with 20 steps of every variant (default: ${DEFAULT-VALUE}).")
    int rounds = 40;

    Supplier<List<String>> problems;
    private Supplier<Run> run;

    /** @param experiment the experiment */
    DeclaredCommand(Experiment experiment) {
        this.experiment = experiment;
    }

    @Override
    public String name() {
        return experiment.command;
    }

    /** Called by the parser when it knows all options. */
    @Spec
    void declare(CommandSpec spec) {
        spec.name(name()).usageMessage().description(experiment.about);
        for (Choice choice : Choice.values()) {
            if (!experiment.options.contains(choice)) {
                spec.remove(spec.findOption(choice.option));
            }
        }
    }

    @Override
    protected void read(Mistakes mistakes) {
        options.read(mistakes, this, experiment.scene, experiment.solvers);
        problems = mistakes.value(() -> names("problem", "problem", problem, WorkProblem.NAMES));
        mistakes.check(() -> frames.ifPresent(number -> requireWithin("frames", number, 1, MOST_FRAMES)));
        mistakes.check(() -> requireWithin("decades", decades, 5, 8));
        mistakes.check(() -> requireWithin("columns", columns, 2, MOST_COLUMNS));
        mistakes.check(() -> requireWithin("rounds", rounds, 1, Integer.MAX_VALUE));
        run = mistakes.value(() -> experiment.plan.of(this));
        super.read(mistakes);
    }

    @Override
    protected ResultPage measure(OutputFolder folder, ProgressListener progress) {
        return run.get().measure(folder, progress);
    }

    /** @return the results, under the name of the experiment */
    ResultPage page(String title, List<String> text, List<Picture> pictures, List<DataTable> tables) {
        return new ResultPage(name(), title, text, pictures, tables);
    }
}
