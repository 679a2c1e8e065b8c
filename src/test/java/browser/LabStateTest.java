package browser;

import static java.util.stream.Collectors.joining;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Texts.assertHas;

import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.openqa.selenium.By;
import org.openqa.selenium.Keys;

/** How the page starts, is steered by keys, and keeps its state in its address. */
class LabStateTest extends LabPageTestCase {
    private static final String STATE = """
            const value = id => document.getElementById(id).value;
            return [value('scene'), value('solver'), value('deltaTNumber'), value('particle'), value('vertical'),
              document.querySelector('.CodeMirror').CodeMirror.getValue(), document.getElementById('clock').textContent,
              ...window.lab.view.camera.describe().map(number => number.toFixed(9)),
              ...window.lab.view.moment.state].join();
            """;

    /** The titles of axes that are longer than the picture of their plot. */
    private static final String CUT_TITLES = """
            const {energy, phase, distances} = window.lab;
            return [energy, phase, distances].map(one => one.plot)
              .filter(plot => plot.root.offsetParent).flatMap(plot => plot.axes.slice(1).filter(({label}) => {
                const size = parseFloat(getComputedStyle(document.body).getPropertyValue('--type'));
                plot.ctx.font = 'bold ' + size * devicePixelRatio + 'px system-ui, sans-serif';
                const half = plot.ctx.measureText(label).width / 2, middle = plot.bbox.top + plot.bbox.height / 2;
                return middle - half < 0 || middle + half > plot.ctx.canvas.height;
              }).map(({label}) => label));
            """;

    /** A row of README's table of slides; its run, if it has one, is what stands behind the task's name. */
    private static final Pattern SLIDE = Pattern.compile(
            "(?m)^\\| (?<slide>[^|`]+) \\| `[\\w.`, ]+ \\| `gradle (?:run(?<run> [^`]+)|\\w+[^`]*)` \\|$");

    @ParameterizedTest
    @ValueSource(strings = {"file", "http"})
    void aLinkBringsSceneSolverCameraAndMomentBackInAFreshBrowser(String scheme) throws IOException {
        HttpServer server = HttpServer.create(new InetSocketAddress("localhost", 0), 0);
        server.createContext("/", exchange -> {
            exchange.sendResponseHeaders(200, Files.size(Browser.page()));
            Files.copy(Browser.page(), exchange.getResponseBody());
            exchange.close();
        });
        server.start();
        try {
            if (scheme.equals("http")) {
                page.go("http://localhost:" + server.getAddress().getPort());
            }
            page.openScene("41-double-pendulum");
            edit("duration: ", "duration: 60 #");       // a busy machine may pause it late
            until("view.facts.duration === 60");
            page.choose("solver", "euler");
            setStep("0.002");
            page.choose("vertical", "y (m)");
            page.choose("horizontal", "time (s)");
            press(" ");
            until("number('clock') > 0.3");
            press(" ");
            until("text('start') === 'Continue'");
            page.element("view").sendKeys(Keys.ARROW_RIGHT, "-");
            page.click("copyLink");
            until("text('note').includes('link is in the')");
            assertEquals(scheme.equals("file"), page.text("note").contains("links work on this machine alone"));
            assertEquals(scheme.equals("http"), page.script(
                    "return document.querySelector('#note input')?.value ?? '';")
                    .equals("<iframe src=\"" + page.driver().getCurrentUrl()
                    + "\" width=\"1000\" height=\"700\"></iframe>"));
            String link = page.driver().getCurrentUrl();
            assertTrue(link.startsWith(scheme) && link.length() < 2500, link);
            try (Browser fresh = Browser.open(1280, 900)) {
                fresh.go(link);
                fresh.await("the moment", () -> fresh.text("clock").equals(page.text("clock"))
                        && fresh.text("start").equals("Continue")
                        && (Boolean) fresh.script("return Boolean(window.lab.view.camera.describe());"));
                page.script("document.getElementById('note').replaceChildren();");  // the picture has its size again
                page.await("the same", () -> page.script(STATE).equals(fresh.script(STATE)));
                fresh.go(link.substring(0, link.length() - 30));
                assertHas(fresh.text("note"), "damaged");
            }
        } finally {
            server.stop(0);
        }
    }

    private void press(CharSequence key) {
        page.driver().findElement(By.tagName("body")).sendKeys(key);
    }

    @Test
    void aSceneTooLongForALinkIsSavedAsAFileThatThePageOpens() throws IOException {
        page.script("document.activeElement.blur(); "
                + " HTMLAnchorElement.prototype.click = function () { window.saved = [this.download, this.href]; };");
        String comment = new Random(1).ints(20_000, 'a', 'z').mapToObj(Character::toString).collect(joining());
        edit("title:", "# " + comment + "\ntitle:");
        page.choose("solver", "verlet");
        page.click("copyLink");
        until("text('note').includes('too long for a link')");
        page.driver().findElement(By.cssSelector("#note button")).click();
        assertFalse(page.driver().getCurrentUrl().contains("#"));
        Path file = Files.writeString(Browser.page().resolveSibling("lab.json"), (String) page.later("""
                const [done] = arguments; fetch(window.saved[1]).then(file => file.text()).then(done);"""));
        page.openScene("01-falling-particle");
        page.click("showEditor");
        page.element("open").sendKeys(file.toAbsolutePath().toString());
        until("value('scene').startsWith('02') && value('solver') === 'verlet'");
        Files.writeString(file, "{");
        page.script("document.getElementById('open').value = '';");
        page.element("open").sendKeys(file.toAbsolutePath().toString());
        until("text('note').startsWith('lab.json is damaged')");
    }

    @Test
    void keysStepBothWaysAndFillTheScreen() {
        page.openScene("02-one-spring");
        for (String clock : List.of("0.05 s", "0.1 s", "0.15 s")) {
            press(Keys.ARROW_RIGHT);
            page.await(clock, () -> page.text("clock").equals(clock));
        }
        press(Keys.ARROW_LEFT);
        until("text('clock') === '0.1 s'");
        assertEquals("2", page.text("steps"));
        page.element("deltaTNumber").sendKeys("f", " ", Keys.ARROW_RIGHT);
        press("f");
        until("Boolean(document.fullscreenElement)");
        assertEquals("0.1 s", page.text("clock"));
        press("f");
        until("!document.fullscreenElement");
    }

    @Test
    void aSceneMovesAtOnceUnlessTheSystemAsksForReducedMotion() {
        Browser.sleep(500);
        assertEquals("0", page.text("steps"));
        page.driver().executeCdpCommand("Emulation.setEmulatedMedia", Map.of("features",
                List.of(Map.of("name", "prefers-reduced-motion", "value", "no-preference"))));
        page.go(Browser.page().toUri().toString());
        until("number('steps') > 0 && number('pace') > 0");
        page.choose("scene", "06-bouncing-ball.yaml");
        until("text('teaches').includes('bounce') && number('steps') > 0");
    }

    @Test
    void aLectureGoesThroughReadmesSlidesByKeysInLargeType() throws IOException {
        List<?> stations = (List<?>) page.script("return JSON.parse(document.getElementById('stations').textContent)"
                + ".map(({slide, scene, solver = ''}) => [slide, scene, solver]);");
        Matcher row = SLIDE.matcher(Files.readString(Path.of("README.md")));
        for (Object each : stations) {
            List<?> station = (List<?>) each;
            assertTrue(row.find());
            assertEquals(row.group("slide"), station.get(0));
            String options = " -Pscene=" + Integer.parseInt(station.get(1).toString().substring(0, 2)) + " -Psolver="
                    + station.get(2) + " ";
            String run = row.group("run");
            assertTrue(run == null || options.contains(run + " "), station + " and " + row.group());
        }
        assertTrue(row.find() && row.group().contains("Interface to DE Solver") && !row.find(), "README's last slide");
        edit("title: ", "title: My own, #");
        press("l");
        until("text('ask').startsWith('Which six numbers') && view.facts.title === 'A falling particle'");
        assertEquals("21px", page.script("return getComputedStyle(document.getElementById('clock')).fontSize;"));
        press(Keys.PAGE_DOWN);
        until("view.facts.title.includes('damped spring')");
        press(" ");
        until("number('steps') > 0");
        press(Keys.PAGE_UP);
        until("value('slides') === '0' && !element('nextSlide').disabled && element('previousSlide').disabled");
        page.choose("slides", "10");
        until("caption().startsWith('euler') && value('solver') === 'midpoint'");
        page.click("step");
        until("text('steps') === '1'");
        // the circle and the verdict that the question asks for are beside the picture
        until("text('nearest').includes('Nearest: midpoint (run 1); euler (run 2) is ')");
        assertEquals(List.of(), page.script("""
                return ['phase', 'nearest'].filter(id => {
                  const {top, bottom} = document.getElementById(id).getBoundingClientRect();
                  return !(bottom > top && top > 0 && bottom < innerHeight);
                });
                """));
        assertEquals(List.of(), page.script(CUT_TITLES));
        page.screenshot("lecture");
        Object link = page.later("window.lab.address.write().then(arguments[0]);");
        page.reload();
        until("value('slides') === '10' && caption().startsWith('euler')");
        press("l");
        until("!document.body.classList.contains('lecture') && view.facts.title.startsWith('My own')");
        page.await("another address", () -> !page.driver().getCurrentUrl().equals(link));
        page.script("location.href = arguments[0];", link);
        until("value('slides') === '10' && caption().startsWith('euler') && text('endLecture') === 'End'");
        press("l");
        until("!document.body.classList.contains('lecture') && caption().startsWith('euler')");
        assertEquals("midpoint", page.script("return document.getElementById('solver').value;"));
        assertTrue(page.element("copyLink").isDisplayed());
    }

    @Test
    void scenesAreChosenByPictureAndTitle() {
        page.click("showGallery");
        until("[...document.querySelectorAll('#pictures img')].every(picture => picture.naturalWidth === 320)");
        page.screenshot("gallery");
        page.driver().findElement(By.xpath("//button[contains(., '06 A bouncing ball')]")).click();
        page.await("its text", () -> page.text("teaches").startsWith("A bouncing ball: "));
        assertFalse(page.element("gallery").isDisplayed());
    }
}
