package particles.app.cli;

import deSolvers.text.DidYouMean;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import java.util.stream.Stream;
import particles.experiments.runs.SolverChoice;
import picocli.CommandLine.Option;

/** A command with its own folder of results, build/out/NAME. */
public abstract class ResultsCommand extends ProgramCommand {
    /** The folder of all results. */
    public static final Path RESULTS = Path.of("build", "out");

    @Option(names = "--out", paramLabel = "FOLDER",
            description = "Where the results go (default: a folder of its own in build/out).")
    private String out;

    private final Instant begin = Instant.now();
    private Path folder;

    /** @return the name of its folder in build/out */
    protected String folderName() {
        return name();
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
    protected final Path getFolder() {
        return folder;
    }

    /** Files are written whole or not at all: those that are newer than the command are complete results. */
    @Override
    public String whenStopped() {
        boolean complete = false;
        if (folder != null && Files.exists(folder)) {   // null while the options are read
            try (Stream<Path> files = Files.walk(folder)) {
                complete = files.anyMatch(file -> Files.isRegularFile(file) && !file.getFileName().toString()
                        .startsWith(".") && file.toFile().lastModified() >= begin.toEpochMilli());
            } catch (IOException | UncheckedIOException e) {
                return super.whenStopped();
            }
        }
        return super.whenStopped() + (complete ? "; what was complete is in " + folder : " before it had a result");
    }

    /** @return the solvers that the option names */
    public final List<SolverChoice> solverChoices(String names) {
        return made("solvers", () -> SolverChoice.list(names));
    }

    /**
     * Reads a list of names, separated by commas, or all.
     *
     * @param option the option
     * @param what   what the names are of
     * @param typed  the list
     * @param known  the names that there are
     * @return one or more of them
     */
    protected final List<String> names(String option, String what, String typed, List<String> known) {
        List<String> names = typed.strip().equals("all") ? known
                : made(option, () -> SolverChoice.separated(typed));
        for (String name : names) {
            if (!known.contains(name)) {
                throw wrong(option, "no " + what + " is called '" + name + "'"
                        + DidYouMean.hint(name, known, "'%s'"::formatted) + " known: " + String.join(", ", known));
            }
        }
        if (names.isEmpty()) {
            throw wrong(option, "choose at least one " + what + "; known: " + String.join(", ", known));
        }
        return names;
    }
}
