package particles.app.experiments;

import java.util.List;
import java.util.function.Supplier;
import particles.app.experiments.Experiment.Run;
import particles.experiments.runs.ProgressListener;
import particles.experiments.runs.SolverChoice;
import particles.experiments.work.WorkProblem;
import particles.output.files.OutputFolder;
import particles.output.report.Picture;
import particles.output.report.ResultPage;
import particles.scene.format.SceneDescription;
import particles.view.DataTable;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** The command of a declared experiment. */
public final class DeclaredCommand extends ExperimentCommand {
    private final Experiment experiment;

    @Mixin
    private final SceneOptions options;

    @Option(names = "--solvers", paramLabel = "NAMES", description = "Solvers, separated by commas, or all.")
    private String solverNames;

    @Option(names = "--problem", paramLabel = "NAMES", description = "Problems, separated by commas:"
            + " oscillator, pendulum, kepler, network, stiff-chain, cloth (default: ${DEFAULT-VALUE}).")
    private String problem = "all";

    private Supplier<List<SolverChoice>> solvers;
    private Supplier<List<String>> problems;
    private Supplier<Run> run;

    /** @param experiment the experiment */
    DeclaredCommand(Experiment experiment) {
        this(experiment, new SceneOptions(), experiment.solvers());
    }

    /**
     * @param experiment the experiment
     * @param options    the scene, as typed
     * @param solvers    the names of the solvers, as typed
     */
    DeclaredCommand(Experiment experiment, SceneOptions options, String solvers) {
        this.experiment = experiment;
        this.options = options;
        solverNames = solvers;
    }

    @Override
    public String name() {
        return experiment.command();
    }

    /** Called by the parser when it knows all options. */
    @Spec
    void declare(CommandSpec spec) {
        spec.name(name()).usageMessage().description(experiment.about());
        for (String option : List.of("--scene", "--set", "--solvers", "--problem")) {
            if (!experiment.options().contains(option)) {
                spec.remove(spec.findOption(option));
            }
        }
    }

    @Override
    protected void read(Mistakes mistakes) {
        options.read(mistakes, this, experiment.scene());
        solvers = mistakes.value(() -> solverChoices(solverNames));
        problems = mistakes.value(() -> names("problem", "problem", problem, WorkProblem.NAMES));
        run = mistakes.value(() -> experiment.plan().of(this));
        super.read(mistakes);
    }

    @Override
    protected ResultPage measure(OutputFolder folder, ProgressListener progress) {
        return run.get().measure(folder, progress);
    }

    boolean hasScene() {
        return options.hasScene();
    }

    SceneDescription scene() {
        return options.scene();
    }

    List<SolverChoice> solvers() {
        return solvers.get();
    }

    List<String> problems() {
        return problems.get();
    }

    /** @return the results, under the name of the experiment and with what it teaches */
    ResultPage page(String title, List<Picture> pictures, List<DataTable> tables) {
        return new ResultPage(name(), title, List.of(experiment.teaches()), pictures, tables);
    }
}
