package particles.output.report;

import java.util.List;
import java.util.Optional;
import particles.output.files.OutputException;
import particles.output.files.OutputFolder;

/** Writes results as JUnit XML reports, which autograders read. */
public final class JUnitXml {
    private JUnitXml() {
    }

    /**
     * One result.
     *
     * @param name    the name of the item
     * @param failure the mistake in one line; empty if it is right
     * @param details further comments in either case, a line each
     */
    public record Case(String name, Optional<String> failure, List<String> details) {
    }

    /**
     * Writes TEST-SUITE.xml.
     *
     * @param folder the output folder
     * @param suite  the name of the test suite
     * @param owner  the class name of all results
     * @param cases  the results
     * @throws OutputException if it cannot be written
     */
    public static void write(OutputFolder folder, String suite, String owner, List<Case> cases) {
        StringBuilder xml = new StringBuilder(Html.fill("""
                <?xml version="1.0" encoding="UTF-8"?>
                <testsuite name="%s" tests="%s" failures="%s" errors="0" skipped="0" time="0">
                """, suite, cases.size(), cases.stream().filter(c -> c.failure().isPresent()).count()));
        for (Case result : cases) {
            String details = String.join("\n", result.details());
            xml.append(Html.fill("  <testcase classname=\"%s\" name=\"%s\" time=\"0\">", owner, result.name()))
                    .append(result.failure().map(why -> Html.fill(
                            "<failure type=\"mark\" message=\"%s\">%s</failure>", why, details))
                            .orElseGet(() -> Html.fill("<system-out>%s</system-out>", details)))
                    .append("</testcase>\n");
        }
        folder.write("TEST-" + suite + ".xml", xml + "</testsuite>\n");
    }
}
