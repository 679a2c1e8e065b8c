package particles.app.student;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static particles.Texts.assertHas;
import static particles.Texts.assertStarts;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import particles.app.cli.ExitCode;

/** Makes checks here, or in a process of their own. */
final class Checks {
    private Checks() {
    }

    /** @return what the screen shows of a check that ends with this code; its report is in the folder's report */
    static String here(ExitCode expected, Check check, Path folder) {
        List<String> lines = new ArrayList<>();
        ExitCode code = new CheckRun(check, folder.resolve("report"), (shown, report) -> lines.addAll(report)).run();
        assertEquals(expected, code, lines::toString);
        return String.join("\n", lines);
    }

    /**
     * Checks a class that never returns, which must end with the code for bad input, and compares the report with the
     * screen.
     *
     * @return the screen's line on the failure
     */
    static String failureOf(Check check, Class<?> planted, Path folder) throws IOException {
        StudentProcess.Outcome end = StudentProcess.run(check, folder, Map.of());
        String screen = String.join("\n", end.lines());
        assertEquals(ExitCode.BAD_INPUT, end.code(), screen);
        String report = Files.readString(check.report(folder));
        assertStarts(report, "# " + planted.getName() + ": The check did not finish.");
        assertEquals(planted.getSimpleName(), end.lines().get(0).replaceFirst("(.*[.$])?(\\w+): wrong.*", "$2"),
                "the verdict comes first: " + screen);
        String first = end.lines().stream().filter(line -> line.startsWith("WRONG, failure: ")).findFirst()
                .orElseThrow().replaceFirst("WRONG, ", "");
        assertHas(report, "- WRONG, " + first);
        assertHas(screen, "report: " + check.report(folder));
        return first;
    }
}
