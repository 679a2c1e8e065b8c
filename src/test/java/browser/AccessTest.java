package browser;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.io.InputStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.openqa.selenium.Dimension;
import particles.app.Main;
import particles.app.cli.OptionStyle;
import particles.app.cli.Program;
import particles.app.run.StopRequest;

/** axe-core, which looks for what keeps people from using a page with a screen reader, the keys or weak eyes. */
class AccessTest extends LabPageTestCase {

    private static final String AXE = axe();

    private static String axe() {
        try (InputStream stream = AccessTest.class.getResourceAsStream("/axe.min.js")) {
            return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private void assertAccessible(String what) {
        page.script(AXE);
        assertEquals(List.of(), page.later("""
                const [done] = arguments;
                axe.run().then(({violations}) => done(violations.flatMap(({id, help, nodes}) =>
                  nodes.map(({html, failureSummary}) => [id, help, html, failureSummary].join('; ')))));
                """), what);
    }

    @ParameterizedTest
    @ValueSource(strings = {"light", "dark"})
    void pageAndLectureHaveNoViolation(String scheme) {
        page.driver().executeCdpCommand("Emulation.setEmulatedMedia", Map.of("features",
                List.of(Map.of("name", "prefers-color-scheme", "value", scheme))));
        page.openScene("02-one-spring");
        page.click("addPanel");
        until("caption().startsWith('euler')");
        page.script("document.querySelectorAll('details').forEach(details => { details.open = true; });"
                + " ['labels', 'arrows', 'forces'].forEach(id => document.getElementById(id).click());");
        page.click("showEditor");
        runToTheEnd();
        assertAccessible("page");
        setStep("0.1");
        edit("solver: rk4", "solver: rk5");
        until("text('errors').includes('rk4')");
        assertAccessible("mistake");
        edit("solver: rk5", "solver: rk4");
        page.click("build");
        assertAccessible("building");
        page.click("showGallery");
        assertAccessible("gallery");
        page.click("closeGallery");
        page.click("startLecture");
        page.choose("slides", "10");
        until("caption().startsWith('euler') && value('solver') === 'midpoint'");
        assertAccessible("lecture");
        page.driver().manage().window().setSize(new Dimension(390, 800));
        assertAccessible("phone");
    }

    @Test
    void aReportHasNoViolation() {
        Path out = Path.of("build", "tmp", "browserTests", "report");
        PrintWriter lines = new PrintWriter(new StringWriter());
        new Program(Main.commands(new StopRequest()), OptionStyle.GRADLE, lines, lines).execute("report", "--scene=2",
                "--experiments=energyDrift,stability", "--out=" + out);
        page.driver().get(out.resolve("report.html").toUri().toString());
        assertAccessible("report");
    }
}
