package browser;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.openqa.selenium.OutputType;
import org.openqa.selenium.interactions.PointerInput.Kind;

/** What the page draws: the scene with its labels and arrows, and plots. */
class PictureTest extends LabPageTestCase {

    @Test
    void pictureAndPlotsAreDrawn() {
        page.openScene("09-cloth-in-wind");
        page.await("the cloth", () -> redPixels("#view canvas") > 1000);
        long before = redPixels("#view canvas");
        page.click("start");
        until("number('clock') > 0.5");
        page.click("start");
        page.await("a cloth that moves", () -> redPixels("#view canvas") != before);
        page.await("curves of energy", () -> linePixels("#energy canvas") > 200);
        page.await("a curve in phase space", () -> linePixels("#phase canvas") > 100);
        page.screenshot("cloth");
    }

    /** Those of the cloth's front. */
    private long redPixels(String canvas) {
        return pixels(canvas, "r > 1.5 * g && r > 1.5 * b && a > 0");
    }

    /** Those of a curve, in the second colour. */
    private long linePixels(String canvas) {
        return pixels(canvas, "b > r + 60 && b > g + 20 && a > 0");
    }

    private long pixels(String canvas, String condition) {
        return (Long) page.script("""
                const from = document.querySelector(arguments[0]);
                const copy = document.createElement('canvas');
                copy.width = from.width;
                copy.height = from.height;
                copy.getContext('2d').drawImage(from, 0, 0);
                const data = copy.getContext('2d').getImageData(0, 0, copy.width, copy.height).data;
                let count = 0;
                for (let i = 0; i < data.length; i += 4) {
                  const [r, g, b, a] = data.subarray(i, i + 4);
                  count += (%s) ? 1 : 0;
                }
                return count;
                """.formatted(condition), canvas);
    }

    /** In a browser whose workers never answer; a worker that does is then asked for the same. */
    @Test
    void theFirstPictureNeedsNoEngineAndShowsWhatTheEngineTells() {
        page.driver().executeCdpCommand("Page.addScriptToEvaluateOnNewDocument", Map.of("source",
                "window.Answering = window.Worker; window.Worker = class { postMessage() {} };"));
        page.go(Browser.page().toUri().toString());
        page.await("a ball", () -> pixels("#view canvas", "r > 1.5 * b && a > 0") > 100);
        page.click("start");
        assertEquals("Pause", page.text("start"));
        String plain = "const plain = value => JSON.parse(JSON.stringify(value));";
        assertEquals(page.script(plain + "return plain([window.lab.view.facts, window.lab.view.moment]);"),
                page.later(plain + """
                const [done] = arguments, worker = new Answering(window.lab.engine), told = [];
                const {textContent: text, dataset: {name, first}} = document.querySelector('[data-first]');
                worker.onmessage = ({data}) => told.push(data) === 2 && done(plain([told[0].facts, told[1]]));
                worker.postMessage({type: 'open', file: name, text, solver: first, deltaT: '', tolerance: 0, set: ''});
                """));
    }

    /** The ground is dark where the lamp does not reach it; the wall of a hollow has darker meridians. */
    @ParameterizedTest
    @CsvSource({"10-jelly-block, r > b + 4 && r < b + 12 && r > 115 && r < 140",
        "21-balls-and-bowl, r < data[i - 8] - 6 && r < data[i + 8] - 6"})
    void shadowsAndTheGridOfAHollowAreDrawn(String scene, String condition) {
        page.openScene(scene);
        page.await("dark pixels", () -> pixels("#view canvas", condition) > 1000);
        page.screenshot(scene);
    }

    @Test
    void theLampAndTheGroundFollowTheCamera() {
        page.openScene("10-jelly-block");
        until("view.litHeight === view.camera.viewHeight");
        page.element("view").sendKeys("-".repeat(12));      // 3.5 times as far; lit for at least 1 / 1.5 of that
        until("view.litHeight > 2 * view.camera.viewHeight");
        page.screenshot("from-afar");
    }

    @Test
    void aFixedParticleAmongGlowingOnesIsASmallBall() {
        page.openScene("28-fire");
        until("text('particle') === 'hearth' && value('particle') === ''");
        page.click("start");
        until("view.spots.count > 50 && value('particle').length > 0");
        assertEquals(1, value("view.balls.count"));
        assertEquals(0.13 / 3, value("view.radius(0)"), 1e-12);
        page.screenshot("fire");
    }

    /** As in the frames: springs are coils of tubes, ten pieces a turn, also a soft one beside many; rods are bars. */
    @ParameterizedTest
    @CsvSource(delimiter = ';', value = {"02-one-spring; ''; ''; 160", "40-rigid-pendulum; ''; ''; 1",
        "09-cloth-in-wind; ', fixed: true}\n\nsprings:\n  - {from: foot, to: top, stiffness: 1}';"
        + "'}\nsprings:\n  - {from: foot, to: top, stiffness: 0.1}'; 160"})
    void springsAndRodsAreTubes(String scene, String from, String to, int tubes) {
        page.openScene(scene);
        edit(from, to);
        until("view.springs.count === " + tubes);
    }

    @Test
    void aBlockHasEdgesAndHidesItsSprings() {
        page.openScene("10-jelly-block");
        until("view.surfaces[0].geometry.attributes.normal.array.some(part => part !== 0)");
        assertEquals(6, value("""
                new Set([...view.surfaces[0].geometry.attributes.normal.array].map((part, k, all) => k % 3 ? '' :
                  [0, 1, 2].map(axis => Math.round(100 * all[k + axis]) + 0).join()).filter(Boolean)).size"""));
        assertEquals(0, value("""
                view.shownSprings.filter(s => view.structure.springs.slice(2 * s, 2 * s + 2)
                  .some(end => view.surfaces[0].triangles.includes(end))).length"""));
    }

    @Test
    void runsBesideEachOtherAreBothSeenInTheNextSceneToo() {
        page.click("addPanel");
        until("document.querySelector('figure canvas')");
        page.openScene("47-pile-of-balls");
        page.click("start");
        until("number('clock') > 0.02");
        page.click("start");
        for (String canvas : List.of("#view canvas", "figure canvas")) {
            page.await("balls", () -> pixels(canvas, "r > 120 && r > 1.5 * b") > 500);
        }
        page.screenshot("two-runs");
    }

    @ParameterizedTest
    @CsvSource({"light, 169, 195, 220", "dark, 8, 11, 20"})
    void theSkyIsThatOfTheFrames(String scheme, int red, int green, int blue) {
        page.driver().executeCdpCommand("Emulation.setEmulatedMedia",
                Map.of("features", List.of(Map.of("name", "prefers-color-scheme", "value", scheme))));
        page.openScene("02-one-spring");
        page.await("the sky", () -> pixels("#view canvas", "Math.abs(r - %d) + Math.abs(g - %d) + Math.abs(b - %d) < 4"
                .formatted(red, green, blue)) > 500);
    }

    @Test
    void dropsThatTouchHaveOneSurface() {
        page.openScene("25-drop");
        until("view.blobs.object.geometry.index?.count > 3000");
        // Euler: V - E + F = 2, where E = 3 F / 2
        assertEquals(2, value("view.blobs.object.geometry.attributes.position.count"
                + " - view.blobs.object.geometry.index.count / 6"));
        page.await("its colour", () -> pixels("#view canvas", "b > 1.5 * r && b > 100 && a > 0") > 5000);
        page.screenshot("drop");
    }

    @Test
    void labelsOfASceneAreBesideItsParticles() {
        page.openScene("14-thrown-dumbbell");
        page.await("the labels", () -> !labels().isEmpty());
        assertEquals(List.of("2 kg", "1 kg"), labels());
        page.click("labels");
        assertEquals(List.of("heavy: 2 kg", "light: 1 kg", "stone"), labels());
        assertEquals(true, page.script("""
                const view = document.getElementById('view').getBoundingClientRect();
                return [...document.querySelectorAll('#view .name')].every((name, i) => {
                  const box = name.getBoundingClientRect(), [x, y] = window.lab.view.onScreen(i);
                  return Math.abs(box.left - view.left - x - 20) <= 14         // a ball's radius and 6 pixels
                    && Math.abs((box.top + box.bottom) / 2 - view.top - y) <= 1;
                });
                """));
    }

    private List<?> labels() {
        return (List<?>) page.script(
                "return [...document.querySelectorAll('#view .name')].map(name => name.textContent);");
    }

    @Test
    void arrowsFollowTheVelocitiesWhereASceneSaysSo() {
        page.openScene("01-falling-particle");
        page.await("arrows", () -> arrowPixels() > 50);
        assertEquals(List.of(true, true), page.script(SIGNS));              // to the right and up
        page.click("arrows");
        page.await("no arrows", () -> arrowPixels() == 0);
        page.click("arrows");
        runToTheEnd();
        page.await("arrows", () -> arrowPixels() > 50);
        assertEquals(List.of(true, false), page.script(SIGNS));             // to the right and down
        page.screenshot("arrows");
        page.openScene("02-one-spring");
        page.await("no arrows", () -> arrowPixels() == 0);
    }

    /** Whether the first arrow goes to the right, and up. */
    private static final String SIGNS = """
            const [x0, y0, x1, y1] = document.querySelector('#view .arrows path').getAttribute('d').match(/[-.0-9]+/g);
            return [x1 - x0 > 0, y1 - y0 < 0];
            """;

    /** Pixels of the colour of arrows in what is seen. */
    private long arrowPixels() {
        try {
            BufferedImage seen = ImageIO.read(new ByteArrayInputStream(
                    page.driver().getScreenshotAs(OutputType.BYTES)));
            return IntStream.of(seen.getRGB(0, 0, 760, 600, null, 0, 760)).filter(rgb -> (rgb & 0xffffff) == 0x009e73)
                    .count();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @Test
    void withoutACameraOfItsOwnASceneStaysInThePicture() {
        page.openScene("01-falling-particle");
        setStep("0.001");
        runToTheEnd();
        until("[element('view').clientWidth, element('view').clientHeight].every((size, i) =>"
                + " Math.abs(view.onScreen(0)[i] / size - 0.5) < 0.49)");
        assertTrue(pixels("#view canvas", "r > 1.5 * b && a > 0") > 100);
    }

    @Test
    void withOmegaOneTheExactCurveIsDrawnAsACircle() {
        page.openScene("02-one-spring");
        runToTheEnd();
        until("""
                ['x', 'y'].map(axis => Math.abs(phase.plot.valToPos(1, axis) - phase.plot.valToPos(-1, axis)))
                  .every((size, i, [across]) => Math.abs(size - across) <= 0.01 * across)""");
    }

    @Test
    void theChosenParticleIsTheOneThatIsClicked() {
        page.openScene("05-hanging-chain");
        hold(Kind.MOUSE, 3).release().perform();
        until("value('particle') === view.structure.ids[3]");
    }
}
