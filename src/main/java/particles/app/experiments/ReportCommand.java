package particles.app.experiments;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import particles.app.cli.ChartOptions;
import particles.app.cli.Failures;
import particles.app.cli.PrintedProgress;
import particles.app.cli.Program;
import particles.app.cli.ProgramCommand;
import particles.app.cli.ResultsCommand;
import particles.experiments.runs.ProgressListener;
import particles.output.files.OutputException;
import particles.output.files.OutputFolder;
import particles.output.report.Report;
import particles.output.report.Report.Section;
import particles.output.report.ResultPage;
import particles.scene.format.SceneFormat;
import particles.spec.messages.InvalidInputException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code gradle report}: the experiments on one page, for the course or for a scene. */
@Command(name = "report", description =
        "Runs all experiments, of the course or of a scene, and writes one HTML page.")
public final class ReportCommand extends ResultsCommand {
    static final String FILE = "report.html";
    private static final int MOST_LINES = 8;

    private final List<Experiment> experiments;

    @Mixin
    private final ChartOptions charts = new ChartOptions();

    /** The scene of the experiments that look at one; without it, each has its own. */
    @Mixin
    private final SceneOptions scene = new SceneOptions();

    @Option(names = "--solvers", paramLabel = "NAMES", description =
            "The solvers of experiments that look at a scene, separated by commas, or all (default: with a scene "
            + Experiment.FIVE + ").")
    private Optional<String> solvers = Optional.empty();

    @Option(names = "--experiments", paramLabel = "NAMES",
            description = "Experiments, separated by commas (default: ${DEFAULT-VALUE}; with a scene, those"
            + " that look at it).")
    private String names = "all";

    private Supplier<List<Experiment>> chosen;

    /** Creates the report on the experiments of the course. */
    public ReportCommand() {
        this(Experiment.ALL);
    }

    /** @param experiments all experiments, in the order of the report */
    ReportCommand(List<Experiment> experiments) {
        this.experiments = experiments;
    }

    /** @return the commands of these experiments */
    public static List<ProgramCommand> experiments() {
        return Experiment.ALL.stream().<ProgramCommand>map(DeclaredCommand::new).toList();
    }

    @Override
    protected void read(Mistakes mistakes) {
        scene.read(mistakes, this, "");         // a wrong scene is reported here, before the experiments run
        mistakes.check(() -> solverChoices(solvers.orElse(Experiment.FIVE)));
        chosen = mistakes.value(this::readNames);
        super.read(mistakes);
    }

    @Override
    public void run(PrintWriter lines) {
        ProgressListener progress = new PrintedProgress(lines, System::nanoTime);
        List<Section> sections;
        try (OutputFolder folder = OutputFolder.open(getFolder(), FILE)) {
            sections = progress.parts(chosen.get(), (experiment, part) ->
                    section(experiment, (done, what) -> part.reached(done, experiment.command() + ", " + what)));
            new Report((scene.hasScene() ? scene.scene().title() + ": what" : "What")
                    + " accuracy costs", text(), sections, "Made by gradle report of DESolver " + Program.VERSION + ".")
                    .write(folder, FILE);
        }
        for (Section section : sections) {
            lines.printf(Locale.ROOT, "%-15s %s%n", section.task(), section.page().map(ResultPage::title)
                    .orElseGet(() -> "failed: " + section.failure().orElse("")));
        }
        lines.println();
        lines.println("all on one page: " + getFolder().resolve(FILE));
    }

    private List<Experiment> readNames() {
        List<String> wanted = names("experiments", "experiment", names,
                experiments.stream().map(Experiment::command).toList());
        boolean onlyOfScene = scene.hasScene() && names.strip().equals("all");
        return experiments.stream().filter(experiment -> wanted.contains(experiment.command())
                && (!onlyOfScene || experiment.looksAtScene())).toList();
    }

    /** The report on a scene goes to a folder of its own. */
    @Override
    protected String folderName() {
        return !scene.hasScene() ? name() : name() + "-" + scene.getTypedScene().replaceFirst("(?s).*[/\\\\]", "")
                .replaceFirst("[.]yaml$", "");
    }

    /** The section of an experiment, also if it fails; a full disk ends the report. */
    private Section section(Experiment experiment, ProgressListener progress) {
        Path into = getFolder().resolve(experiment.command());
        Optional<ResultPage> page = Optional.empty();
        Optional<String> failure = Optional.empty();
        progress.reached(0, "begins");
        try {
            DeclaredCommand command = command(experiment);
            List<String> mistakes = command.mistakes(getStyle());
            if (!mistakes.isEmpty()) {                      // for example, nothing in the scene limits a step
                throw new InvalidInputException(mistakes);
            }
            page = Optional.of(command.writeInto(into, charts.format(), progress));
        } catch (OutputException e) {
            throw e;
        } catch (RuntimeException e) {
            failure = Optional.of(Failures.lines(e).stream().limit(MOST_LINES).map(String::strip)
                    .collect(Collectors.joining("\n")));
        }
        return new Section(experiment.command(), experiment.about(), into, page, failure);
    }

    /** Experiments on a scene get the report's scene and solvers. */
    private DeclaredCommand command(Experiment experiment) {
        return experiment.looksAtScene() && (scene.hasScene() || solvers.isPresent())
                ? new DeclaredCommand(experiment, scene.hasScene() ? scene : new SceneOptions(),
                        solvers.orElse(Experiment.FIVE))    // all would take long on large scenes
                : new DeclaredCommand(experiment);
    }

    private List<String> text() {
        List<String> text = new ArrayList<>();
        if (scene.hasScene()) {
            text.add(scene.scene().values().get(SceneFormat.TEACHES));
        }
        text.add("Click a column's head to sort a table, or a picture to enlarge it. The numbers behind each"
                + " picture, with all digits, are in the folder with the experiment's name beside this page.");
        return text;
    }
}
