package particles.app.cli;

import java.io.PrintWriter;
import picocli.CommandLine.Option;

/** One thing the program can do: a class with {@code @Command} and its options as {@code @Option} fields. */
public abstract class ProgramCommand {
    @Option(names = "--help", usageHelp = true, description = "Shows these options.")
    private boolean help;

    /**
     * Does it.
     *
     * @param out where results are printed
     * @throws Exception what went wrong; {@link Failures} says what becomes of it
     */
    public abstract void run(PrintWriter out) throws Exception;
}
