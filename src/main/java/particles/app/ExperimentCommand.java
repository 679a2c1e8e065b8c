package particles.app;

import java.io.PrintWriter;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import particles.experiments.ProgressListener;
import particles.output.OutputFolder;
import particles.output.ResultPage;
import particles.output.ResultPageWriter;
import particles.output.TableText;
import picocli.CommandLine.Option;

/** A command that measures something: its page goes to build/out/NAME, its main table to the screen. */
abstract class ExperimentCommand extends ProgramCommand {
    private static final Path RESULTS = Path.of("build", "out");

    @Option(names = "--out", paramLabel = "FOLDER", description = "Where the results go (default: build/out and the task's name).")
    private String out;

    private final OptionStyle style;

    /** @param style how options are typed, for messages */
    ExperimentCommand(OptionStyle style) {
        this.style = style;
    }

    /** @return the experiment's name, which is its task's */
    abstract String name();

    /**
     * Measures.
     *
     * @param folder   where results go that are written as they come, such as an animation
     * @param progress hears how far it is
     * @return what there is to show
     */
    abstract ResultPage measure(OutputFolder folder, ProgressListener progress);

    @Override
    final void run(PrintWriter lines) {
        check();
        try (OutputFolder folder = OutputFolder.open(folder(), name() + ".md")) {
            ResultPage page = measure(folder, new PrintedProgress(lines, System::nanoTime));
            ResultPageWriter.write(folder, page);
            lines.println(page.title());
            lines.println();
            lines.println(page.tables().get(0).title() + ":");
            TableText.plain(page.tables().get(0)).forEach(lines::println);
            lines.println();
            lines.println("pictures, numbers and what they say: " + folder.getPath().resolve(name() + ".md"));
        }
    }

    /** Looks at the options before anything is written or removed. */
    void check() {
    }

    OptionStyle style() {
        return style;
    }

    private Path folder() {
        if (out == null) {                              // picocli leaves an option null that was not given
            return RESULTS.resolve(name());
        }
        try {
            if (!out.isBlank()) {
                return Path.of(out);
            }
        } catch (InvalidPathException e) {
            throw wrong("out", "'" + out + "' is no folder's name: " + e.getReason());
        }
        throw wrong("out", "needs the name of a folder");
    }

    /** @return the failure that says what is wrong with an option */
    Failure wrong(String option, String why) {
        return new Failure(ExitCode.BAD_INPUT, "option " + style.option(option) + ": " + why);
    }

    /** @return the number, if it is finite and over 0 */
    double positive(String option, double value) {
        if (!(value > 0) || !(value <= Double.MAX_VALUE)) {
            throw wrong(option, value + " has to be finite and more than 0");
        }
        return value;
    }
}
