package particles.app.experiments;

import java.io.PrintWriter;
import java.nio.file.Path;
import particles.app.cli.ChartOptions;
import particles.app.cli.PrintedProgress;
import particles.app.cli.ResultsCommand;
import particles.experiments.runs.ProgressListener;
import particles.output.charts.ChartFormat;
import particles.output.files.OutputFolder;
import particles.output.report.ResultPage;
import particles.output.report.TableText;
import picocli.CommandLine.Mixin;

/** A command that runs an experiment: a page in build/out/NAME, and the main table on the screen. */
public abstract class ExperimentCommand extends ResultsCommand {
    /** A table with more rows is in the files only. */
    private static final int MOST_ROWS = 100;

    @Mixin
    private final ChartOptions charts = new ChartOptions();

    /**
     * Measures.
     *
     * @param folder   the folder for results that are written during the experiment, such as an animation
     * @param progress receives the progress
     * @return the results
     */
    protected abstract ResultPage measure(OutputFolder folder, ProgressListener progress);

    @Override
    public void run(PrintWriter lines) {
        ResultPage page = writeInto(getFolder(), charts.format(), new PrintedProgress(lines, System::nanoTime));
        lines.println(page.title());
        lines.println();
        if (page.tables().get(0).rows().size() <= MOST_ROWS) {
            lines.println(page.tables().get(0).title() + ":");
            TableText.plain(page.tables().get(0)).forEach(lines::println);
            lines.println();
        }
        lines.println("report with pictures and numbers: " + getFolder().resolve(name() + ".md"));
    }

    /**
     * Measures, and writes the results.
     *
     * @param path     the folder
     * @param format   the format of the charts
     * @param progress receives the progress
     * @return the results
     */
    final ResultPage writeInto(Path path, ChartFormat format, ProgressListener progress) {
        try (OutputFolder folder = OutputFolder.open(path, name() + ".md")) {
            return measure(folder, progress).write(folder, format);
        }
    }
}
