package particles.app.cli;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.NoSuchElementException;
import particles.experiments.runs.SolverChoice;
import picocli.CommandLine.Option;

/** A command with its own folder of results, build/out/NAME. */
public abstract class ResultsCommand extends ProgramCommand {
    private static final Path RESULTS = Path.of("build", "out");

    @Option(names = "--out", paramLabel = "FOLDER",
            description = "Where the results go (default: a folder of its own in build/out).")
    private String out;

    private final OptionStyle style;
    private Path folder;

    /** @param style the way in which options are typed, for messages */
    protected ResultsCommand(OptionStyle style) {
        this.style = style;
    }

    /** @return the name of its folder in build/out */
    protected String folderName() {
        return name();
    }

    /** @return the way in which options are typed, for messages */
    public final OptionStyle style() {
        return style;
    }

    @Override
    protected void read(Mistakes mistakes) {
        mistakes.check(() -> folder = out == null ? RESULTS.resolve(folderName()) : typed());
    }

    private Path typed() {
        try {
            if (!out.isBlank()) {
                return Path.of(out);
            }
        } catch (InvalidPathException e) {
            throw wrong("out", "'" + out + "' is not a folder name: " + e.getReason());
        }
        throw wrong("out", "needs a folder name");
    }

    /** @return the folder of its results */
    protected final Path folder() {
        return folder;
    }

    /** @return the failure for a wrong option */
    protected final Failure wrong(String option, String why) {
        return new Failure(ExitCode.BAD_INPUT, "option " + style.option(option) + ": " + why);
    }

    /** @return the solvers that the option names */
    public final List<SolverChoice> solverChoices(String names) {
        try {
            return SolverChoice.list(names);
        } catch (NoSuchElementException | IllegalArgumentException e) {
            throw wrong("solvers", e.getMessage());
        }
    }

    /** Refuses a whole number that is out of its range; {@link Integer#MAX_VALUE} is no upper limit. */
    protected final void requireWithin(String option, int value, int least, int most) {
        if (value < least || value > most) {
            throw wrong(option, value + " has to be " + (most == Integer.MAX_VALUE ? least + " or more"
                    : "from " + least + " to " + most));
        }
    }

    /** @return the number, if it is finite and over 0 */
    protected final double positive(String option, double value) {
        if (!(value > 0) || !(value <= Double.MAX_VALUE)) {
            throw wrong(option, value + " has to be finite and more than 0");
        }
        return value;
    }
}
