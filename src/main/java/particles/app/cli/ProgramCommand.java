package particles.app.cli;

import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import particles.scene.SceneException;
import picocli.CommandLine.Option;

/** Base class of a command: a class with {@code @Command} and {@code @Option} fields. */
public abstract class ProgramCommand {
    @Option(names = "--help", usageHelp = true, description = "Shows these options.")
    private boolean help;

    /** @return checks of the options' values; each throws a {@link Failure} or a {@link SceneException} if wrong */
    protected List<Runnable> checks() {
        return List.of();
    }

    /** @return a line for each wrong option; all checks are always made */
    public final List<String> mistakes() {
        Set<String> lines = new LinkedHashSet<>();      // checks that need the same scene report it once
        for (Runnable check : checks()) {
            try {
                check.run();
            } catch (Failure e) {
                lines.addAll(e.lines());
            } catch (SceneException e) {
                lines.addAll(e.getLines());
            }
        }
        return new ArrayList<>(lines);
    }

    /**
     * Runs the command.
     *
     * @param out the output for results
     * @throws Exception any failure; {@link Failures} prints it
     */
    public abstract void run(PrintWriter out) throws Exception;
}
