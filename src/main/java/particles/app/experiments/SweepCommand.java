package particles.app.experiments;

import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import particles.app.cli.PrintedProgress;
import particles.app.cli.Program;
import particles.app.student.StudentLoader;
import particles.experiments.grid.Grid;
import particles.experiments.grid.Grid.Row;
import particles.experiments.grid.GridAxis;
import particles.experiments.grid.GridCharts;
import particles.experiments.grid.Measure;
import particles.experiments.grid.SceneGrid;
import particles.experiments.runs.ProgressListener;
import particles.output.files.OutputFolder;
import particles.output.report.Picture;
import particles.output.report.ResultPage;
import particles.spec.Digest;
import particles.spec.Setting;
import particles.spec.messages.Problems;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code gradle sweep}: runs a scene over values of its keys. */
@Command(name = "sweep", usageHelpWidth = 110, description =
        "Runs a scene over values of its keys, and charts what is measured of each run.", footer = """

        A run that is in FOLDER is not computed again. On several cores or machines, compute parts and
        collect them; every command has the same scene, keys, values and measures:
          S="build/install/desolver/bin/desolver sweep --scene=3"          # after: gradle installDist
          export JAVA_OPTS=-XX:ActiveProcessorCount=1
          seq 16 | parallel $S "'--vary=...'" "'--measure=...'" --part={}/16 --out=parts
          sbatch --wait --array=1-16 --wrap "$S '--vary=...' '--measure=...' \\
              --part=\\$SLURM_ARRAY_TASK_ID/16 --out=parts"                # Slurm
          strategy: {matrix: {part: [1, 2, 3, 4]}}                         # GitHub: --part=$${{matrix.part}}/4,
              # then actions/upload-artifact of the folder 'parts' in each job, and download-artifact in the last
          $S '--vary=...' '--measure=...' --collect=parts                  # the same bytes as one run
        """)
public final class SweepCommand extends ExperimentCommand {
    private static final int DIGITS = 12;

    @Mixin
    private final SceneOptions options = new SceneOptions();

    @Option(names = "--vary", paramLabel = "KEY = VALUES; ...", required = true, description = "One to three keys and"
            + " their values: x, curves and panels of the charts. VALUES are a list, or a range such as"
            + " '0 .. 40 by 5' or '1e-4 .. 1e-1 log 13'.")
    private String vary;

    @Option(names = "--measure", paramLabel = "MEASURE, ...", required = true, description = "What is measured of each"
            + " run, such as 'min x of block, energy lost'; a wrong one lists all of them.")
    private String measure;

    @Option(names = "--part", paramLabel = "K/N", split = "/",
            description = "Computes only part K of N, such as 3/16; --collect then makes the results.")
    private List<Integer> part = List.of(1, 1);

    @Option(names = "--collect", paramLabel = "FOLDER",
            description = "Makes the results from the rows of all parts in this folder, without a run.")
    private Optional<Path> collect = Optional.empty();

    private Supplier<Grid> grid;
    private Supplier<List<Measure>> measures;
    private Supplier<SceneGrid> runs;

    @Override
    protected void read(Mistakes mistakes) {
        super.read(mistakes);
        options.read(mistakes, this, "");
        if (!options.hasScene()) {
            mistakes.check(() -> {
                throw wrong("scene", "names the scene to run, and cannot be left out");
            });
            return;
        }
        grid = mistakes.value(() -> made("vary", () -> new Grid(GridAxis.list(vary).stream().map(axis ->
                axis.in(unit(axis))).toList())));
        measures = mistakes.value(() -> made("measure", () -> Measure.list(measure)));
        runs = mistakes.value(() -> {
            SceneGrid made = new SceneGrid(options::scene, grid.get(), measures.get(), getStyle().option("vary"));
            Objects.requireNonNull(options.scene());        // its own mistakes come first
            made.checkAxes();
            made("measure", () -> {
                made.checkMeasures();
                return made;
            });
            return made;
        });
        mistakes.check(() -> {
            if (part.size() != 2 || part.get(0) < 1 || part.get(0) > part.get(1)) {
                throw wrong("part", "has to be a part of the points, such as 3/16");
            }
            if (collect.isPresent() && part.get(1) > 1) {
                throw wrong("part", "is for computing; all parts are collected together");
            }
            if (collect.isPresent() && !Files.isDirectory(collect.get())) {
                throw wrong("collect", "'" + collect.get() + "' is not a folder");
            }
        });
    }

    private String unit(GridAxis axis) {
        return Setting.of(axis.key(), axis.values().get(0), "", new Problems()).map(options::unit).orElse("");
    }

    /** The beginning of the names of the files with rows of this version, scene, axes and measures. */
    private String rowsName() {
        String read = String.join("\n", options.text(), options.getTypedSet());
        String all = String.join("\n", Program.VERSION, read, StudentLoader.namedIn(read + "\n" + vary).toString(),
                grid.get().axes().stream().map(GridAxis::key).collect(Collectors.joining("\n")),
                measures.get().stream().map(Measure::name).collect(Collectors.joining("\n")));
        return "rows-" + Digest.of(all).substring(0, DIGITS);
    }

    @Override
    public void run(PrintWriter lines) {
        if (part.get(1) == 1) {
            super.run(lines);
            return;
        }
        int rows = rows(new PrintedProgress(lines, System::nanoTime)).size();
        lines.println(rows + " runs are in " + getFolder() + "; make the results with "
                + getStyle().option("collect"));
    }

    @Override
    public String whenStopped() {
        return name() + " was stopped; the same command goes on with the runs that are not there yet";
    }

    @Override
    protected ResultPage measure(OutputFolder folder, ProgressListener progress) {
        List<Row> rows = rows(progress);
        GridCharts charts = new GridCharts(grid.get(), measures.get(), rows);
        String title = options.scene().title();
        long failed = rows.stream().filter(row -> !row.end().equals(SceneGrid.WHOLE)).count();
        String text = rows.size() + " runs" + (failed == 0 ? "." : ", " + failed
                + " of them failed; the last column has the reasons.")
                + (measures.get().size() > charts.drawn().size() ? " Errors are largest distances of a particle at the"
                + " end from " + SceneGrid.REFERENCE + "." : "");
        Set<String> names = new HashSet<>();
        return new ResultPage(name(), title + ", over " + charts.axes(), List.of(text), charts.drawn().stream()
                .map(one -> Picture.panels(pictureName(one.name(), names), one.name() + " over " + charts.axes() + ".",
                title + ": " + one.name(), charts.panels(one, title))).toList(), List.of(charts.table()));
    }

    /** A name that any system allows for a file; numbered if another picture has it, in whatever case. */
    private static String pictureName(String measure, Set<String> taken) {
        String name = measure.replaceAll("[^\\w-]+", "-").replaceFirst("-$", "");
        String free = name;
        for (int k = 2; !taken.add(free.toLowerCase(Locale.ROOT)); k++) {
            free = name + "-" + k;
        }
        return free;
    }

    /** The rows of this part, in the order of the points; those that are there are not computed again. */
    private List<Row> rows(ProgressListener progress) {
        List<List<String>> points = grid.get().part(part.get(0), part.get(1));
        int axes = grid.get().axes().size();
        Path folder = collect.orElseGet(this::getFolder);
        Map<List<String>, Row> rows = RowFile.read(folder, rowsName(), axes, axes + measures.get().size() + 1);
        List<List<String>> missing = points.stream().filter(point -> !rows.containsKey(point)).toList();
        if (collect.isPresent() && !missing.isEmpty()) {
            throw wrong("collect", missing.size() + " of " + points.size() + " runs are not in '" + folder
                    + "', such as " + String.join(", ", missing.get(0)));
        }
        compute(missing, progress).forEach(row -> rows.put(row.at(), row));
        return points.stream().map(rows::get).toList();
    }

    private List<Row> compute(List<List<String>> points, ProgressListener progress) {
        if (points.isEmpty()) {
            return List.of();
        }
        String mine = rowsName() + (part.get(1) == 1 ? "" : "-" + part.get(0) + "of" + part.get(1)) + ".csv";
        try (RowFile file = RowFile.open(getFolder().resolve(mine))) {
            return progress.onAllCores(points, point -> String.join(", ", point), point -> {
                Row row = runs.get().run(point);
                file.add(row);
                return row;
            });
        }
    }
}
