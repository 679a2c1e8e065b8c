package particles.app.experiments;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Optional;
import particles.app.cli.ChartOptions;
import particles.app.cli.OptionStyle;
import particles.app.cli.PrintedProgress;
import particles.experiments.runs.ProgressListener;
import particles.output.charts.ChartFormat;
import particles.output.files.OutputFolder;
import particles.output.report.ResultPage;
import particles.output.report.ResultPageWriter;
import particles.output.text.TableText;
import picocli.CommandLine.Mixin;

/** A command that measures something: its page goes to build/out/NAME, its main table to the screen. */
public abstract class ExperimentCommand extends ResultsCommand {
    @Mixin
    private final ChartOptions charts = new ChartOptions();

    /** @param style how options are typed, for messages */
    public ExperimentCommand(OptionStyle style) {
        super(style);
    }

    /**
     * Measures.
     *
     * @param folder   where results go that are written as they come, such as an animation
     * @param progress hears how far it is
     * @return what there is to show
     */
    protected abstract ResultPage measure(OutputFolder folder, ProgressListener progress);

    @Override
    public final void run(PrintWriter lines) {
        check();
        estimate().ifPresent(lines::println);
        lines.flush();
        ResultPage page = writeInto(folder(), new PrintedProgress(lines, System::nanoTime));
        lines.println(page.title());
        lines.println();
        lines.println(page.tables().get(0).title() + ":");
        TableText.plain(page.tables().get(0)).forEach(lines::println);
        lines.println();
        lines.println("report with pictures and numbers: " + folder().resolve(name() + ".md"));
    }

    /**
     * Measures, and writes all there is to show.
     *
     * @param path     of the folder
     * @param progress hears how far it is
     * @return what was written
     */
    final ResultPage writeInto(Path path, ProgressListener progress) {
        try (OutputFolder folder = OutputFolder.open(path, name() + ".md")) {
            return ResultPageWriter.write(folder, measure(folder, progress), charts.format());
        }
    }

    /** @return what is said before it begins, if it takes longer than a minute and a half, or less is done for that */
    protected Optional<String> estimate() {
        return Optional.empty();
    }

    /** @return what its charts are for */
    protected final ChartFormat format() {
        return charts.format();
    }

    /** Looks at the options before anything is written or removed. */
    protected void check() {
    }
}
