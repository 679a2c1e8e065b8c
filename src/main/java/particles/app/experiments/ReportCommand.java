package particles.app.experiments;

import deSolvers.text.Digits;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import particles.app.cli.ChartOptions;
import particles.app.cli.Failures;
import particles.app.cli.PrintedProgress;
import particles.app.cli.Program;
import particles.app.cli.ResultsCommand;
import particles.experiments.runs.ProgressListener;
import particles.experiments.runs.SolverChoice;
import particles.output.files.OutputException;
import particles.output.files.OutputFolder;
import particles.output.report.Report;
import particles.output.report.Report.Section;
import particles.output.report.ResultPage;
import particles.scene.Overrides;
import particles.scene.format.SceneDescription;
import particles.scene.format.SceneFormat;
import particles.spec.messages.InvalidInputException;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;

/** {@code gradle report}: the experiments on one page, for the course or for a scene. */
@Command(name = "report", description =
        "Runs all experiments, of the course or of a scene, and writes one HTML page.")
public final class ReportCommand extends ResultsCommand {
    static final String FILE = "report.html";
    private static final String SCENE_OPTION = "--scene";
    private static final String DURATION_OPTION = "--duration";
    /** Options that shorten experiments on a page of many: frames of a film, rounds of a measurement. */
    private static final Map<String, String> SHORTER = Map.of("--frames", "100", "--rounds", "15");
    private static final int MOST_LINES = 8;
    private static final double NANO = 1e-9;

    private final List<ExperimentCommand> experiments;

    @Mixin
    private final ChartOptions charts = new ChartOptions();

    @Option(names = SCENE_OPTION, paramLabel = "NAME", description = "The scene that energyDrift, phasePlots, race"
            + " and stability look at: a file, or the name or number of one in scenes (default: each its own).")
    private String scene;

    @Option(names = "--solvers", paramLabel = "NAMES", description =
            "Their solvers, separated by commas, or all (default: with a scene " + RaceCommand.SOLVERS
            + "); without a scene, stability has all.")
    private String solvers;

    @Option(names = "--experiments", paramLabel = "NAMES",
            description = "Experiments, separated by commas (default: ${DEFAULT-VALUE}; with a scene, those"
            + " that look at it).")
    private String names = "all";

    @Option(names = DURATION_OPTION, paramLabel = "SECONDS", description = "A duration other than the scene's.")
    private String duration;

    private Supplier<Optional<SceneDescription>> about;
    private Supplier<List<SolverChoice>> choices;
    private Supplier<List<ExperimentCommand>> chosen;
    /** The reasons why experiments could not run. */
    private final Map<ExperimentCommand, String> failures = new HashMap<>();

    /** @param experiments all experiments, in the order of the report */
    public ReportCommand(List<ExperimentCommand> experiments) {
        this.experiments = experiments;
    }

    @Override
    protected void read(Mistakes mistakes) {
        mistakes.check(() -> {                              // picocli leaves options null that were not given
            if (scene == null && duration != null) {
                throw wrong("duration", "goes with " + getStyle().option("scene") + " only");
            }
        });
        Overrides overrides = new Overrides(getStyle()::option).with("duration", duration);
        mistakes.check(overrides::check);
        // a wrong scene is reported here, before the experiments run
        about = mistakes.value(() -> readScene().map(overrides::applyTo));
        choices = mistakes.value(() -> solverChoices(solvers()));
        chosen = mistakes.value(this::readNames);
        super.read(mistakes);
    }

    @Override
    public void run(PrintWriter lines) {
        List<ExperimentCommand> chosen = this.chosen.get();
        long begin = System.nanoTime();
        chosen.forEach(this::prepare);
        ProgressListener progress = new PrintedProgress(lines, System::nanoTime);
        List<Section> sections;
        try (OutputFolder folder = OutputFolder.open(getFolder(), FILE)) {
            sections = progress.parts(chosen, (experiment, part) ->
                    section(experiment, (done, what) -> part.reached(done, experiment.name() + ", " + what)));
            new Report(title(), text(), sections, Digits.format("Made by gradle report of DESolver %s in %.0f s.",
                    Program.VERSION, (System.nanoTime() - begin) * NANO)).write(folder, FILE);
        }
        for (Section section : sections) {
            lines.printf(Locale.ROOT, "%-15s %4.0f s  %s%n", section.task(), section.seconds(), section.page()
                    .map(ResultPage::title).orElseGet(() -> "failed: " + section.failure().orElse("")));
        }
        lines.println();
        lines.printf(Locale.ROOT, "all on one page, in %.0f s: %s%n", (System.nanoTime() - begin) * NANO,
                getFolder().resolve(FILE));
    }

    private Optional<SceneDescription> readScene() {
        return Optional.ofNullable(scene).map(SceneOptions::read);
    }

    /** All solvers would take long on large scenes. */
    private String solvers() {
        return solvers != null ? solvers : RaceCommand.SOLVERS;
    }

    private List<ExperimentCommand> readNames() {
        List<String> wanted = names("experiments", "experiment", names,
                experiments.stream().map(ExperimentCommand::name).toList());
        boolean onlyOfScene = scene != null && names.strip().equals("all");
        return experiments.stream().filter(experiment -> wanted.contains(experiment.name())
                && (!onlyOfScene || has(experiment, SCENE_OPTION))).toList();
    }

    private static boolean has(ExperimentCommand experiment, String option) {
        return new CommandLine(experiment).getCommandSpec().findOption(option) != null;
    }

    /** A scene's report leaves that of the course alone. */
    @Override
    protected String folderName() {
        return scene == null ? name() : name() + "-" + scene.replaceFirst("(?s).*[/\\\\]", "")
                .replaceFirst("[.]yaml$", "");
    }

    /** Reads the options of an experiment, which fails, for example, if nothing in the scene limits a step. */
    private void prepare(ExperimentCommand experiment) {
        CommandLine line = new CommandLine(experiment);
        try {
            line.setExpandAtFiles(false).parseArgs(options(line.getCommandSpec()));
            List<String> mistakes = experiment.mistakes(getStyle());
            if (!mistakes.isEmpty()) {
                throw new InvalidInputException(mistakes);
            }
        } catch (RuntimeException e) {
            failures.put(experiment, reason(e));
        }
    }

    /** The section of an experiment, also if it fails; a full disk ends the report. */
    private Section section(ExperimentCommand experiment, ProgressListener progress) {
        String purpose = String.join(" ", new CommandLine(experiment).getCommandSpec().usageMessage().description());
        Path into = getFolder().resolve(experiment.name());
        long begin = System.nanoTime();
        Optional<ResultPage> page = Optional.empty();
        try {
            if (!failures.containsKey(experiment)) {
                progress.reached(0, "begins");
                page = Optional.of(experiment.writeInto(into, progress));
            }
        } catch (OutputException e) {
            throw e;
        } catch (RuntimeException e) {
            failures.put(experiment, reason(e));
        }
        return new Section(experiment.name(), purpose, into, (System.nanoTime() - begin) * NANO, page,
                Optional.ofNullable(failures.get(experiment)));
    }

    /** The options of an experiment; experiments on a scene get the report's scene. */
    private String[] options(CommandSpec spec) {
        List<String> options = new ArrayList<>(charts.arguments());
        if (spec.findOption(SCENE_OPTION) != null) {
            if (scene != null) {
                options.add(SCENE_OPTION + "=" + scene);
            }
            // without a scene, stability has all solvers
            if (scene != null || solvers != null && spec.findOption(DURATION_OPTION) != null) {
                options.add("--solvers=" + solvers());
            }
        }
        if (duration != null && spec.findOption(DURATION_OPTION) != null) {
            options.add(DURATION_OPTION + "=" + duration);
        }
        SHORTER.forEach((name, value) -> {
            if (spec.findOption(name) != null) {
                options.add(name + "=" + value);
            }
        });
        return options.toArray(String[]::new);
    }

    private static String reason(RuntimeException thrown) {
        return Failures.lines(thrown).stream().limit(MOST_LINES).map(String::strip).collect(Collectors.joining("\n"));
    }

    private String title() {
        return about.get().map(description -> description.title() + ": what").orElse("What") + " accuracy costs";
    }

    private List<String> text() {
        List<String> text = new ArrayList<>();
        about.get().ifPresent(description -> {
            text.add(description.values().get(SceneFormat.TEACHES));
            boolean alone = chosen.get().stream().allMatch(one -> has(one, SCENE_OPTION));
            text.add("The scene runs with " + String.join(", ", choices.get().stream().map(SolverChoice::label)
                    .toList()) + (duration == null || chosen.get().stream().noneMatch(one -> has(one, DURATION_OPTION))
                    ? "" : ", for " + duration + " s")
                    + (alone ? "." : "; experiments without a scene use their own problems."));
        });
        text.add("Click a column's head to sort a table, or a picture to enlarge it. The numbers behind each"
                + " picture, with all digits, are in the folder with the experiment's name beside this page.");
        return text;
    }
}
