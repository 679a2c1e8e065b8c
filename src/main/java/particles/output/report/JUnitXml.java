package particles.output.report;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import particles.output.files.OutputException;
import particles.output.files.OutputFolder;

/** Writes results as JUnit XML reports, which autograders read. */
public final class JUnitXml {
    private static final String REPORT = """
            <?xml version="1.0" encoding="UTF-8"?>
            <testsuite name="{{suite}}" tests="{{cases.size}}" failures="{{failures}}" errors="0" skipped="0" time="0">
            {{#cases}}
              <testcase classname="{{owner}}" name="{{name}}" time="0">\
            {{#failure}}<failure type="mark" message="{{.}}">{{text}}</failure>{{/failure}}\
            {{^failure}}<system-out>{{text}}</system-out>{{/failure}}</testcase>
            {{/cases}}
            </testsuite>
            """;

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
        String text() {
            return String.join("\n", details);
        }
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
        long failures = cases.stream().filter(one -> one.failure().isPresent()).count();
        folder.write("TEST-" + suite + ".xml", Html.fill(REPORT,
                Map.of("suite", suite, "owner", owner, "failures", failures, "cases", cases)));
    }
}
