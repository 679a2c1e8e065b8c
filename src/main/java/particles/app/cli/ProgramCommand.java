package particles.app.cli;

import java.io.PrintWriter;
import picocli.CommandLine.Option;

/** Base class of a command: a class with {@code @Command} and {@code @Option} fields. */
public abstract class ProgramCommand {
    @Option(names = "--help", usageHelp = true, description = "Shows these options.")
    private boolean help;

    /**
     * Runs the command.
     *
     * @param out where results are printed
     * @throws Exception any failure; {@link Failures} prints it
     */
    public abstract void run(PrintWriter out) throws Exception;
}
