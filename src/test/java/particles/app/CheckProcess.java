package particles.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static particles.Texts.assertHas;
import static particles.Texts.assertStarts;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import particles.app.cli.ExitCode;

/** Runs a check of a class that never returns, in a process with the program's small memory. */
public final class CheckProcess {
    private CheckProcess() {
    }

    /**
     * Runs the check, which must end with the code for bad input, and compares the report with the screen.
     *
     * @param command checkSolver or checkEffect
     * @param option  that names the class
     * @param planted the class
     * @param folder  for the report
     * @return the screen's line on the failure
     */
    public static String failureOf(String command, String option, Class<?> planted, Path folder) throws IOException,
            InterruptedException {
        ChildProgram.End end = new ChildProgram(folder.resolve("lines.txt")).jvm("-Xmx256m").run(command,
                option + planted.getName(), "--inThisProcess", "--out=" + folder);
        String screen = end.lines();
        assertEquals(ExitCode.BAD_INPUT.code(), end.code(), screen);
        String report = Files.readString(folder.resolve(command + ".md"));
        assertStarts(report, "# " + planted.getName() + ": The check did not finish.");
        assertEquals(planted.getSimpleName(), screen.lines().findFirst().orElseThrow()
                .replaceFirst("(.*[.$])?(\\w+): wrong.*",
                "$2"), "the verdict comes first: " + screen);
        String first = screen.lines().filter(line -> line.startsWith("WRONG, failure: ")).findFirst().orElseThrow()
                .replaceFirst("WRONG, ", "");
        assertHas(report, "- **failure**: " + first.replaceFirst("failure: ", ""));
        assertHas(screen, "report: " + folder.resolve(command + ".md"));
        return first;
    }
}
