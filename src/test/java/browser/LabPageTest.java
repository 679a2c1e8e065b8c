package browser;

import static deSolvers.problems.Bounds.assertBelow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Texts.assertHas;
import static particles.Texts.assertStarts;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.openqa.selenium.interactions.PointerInput.Kind;

/** Use of the lab's page in a browser: clicks, keys, and what is shown. */
class LabPageTest extends LabPageTestCase {

    @Test
    void eulerGainsEnergyAndRK4KeepsIt() {
        page.openScene("02-one-spring");
        runToTheEnd();
        assertEquals("252", page.text("steps"));        // 4 pi / 0.05 = 251.3
        assertEquals("1008", page.text("evaluations"));
        assertEquals(1, energyRatio(), 1e-5);           // measured 5e-7
        page.choose("solver", "euler");
        until("text('steps') === '0'");
        runToTheEnd();
        assertEquals("252", page.text("evaluations"));
        // each step multiplies by 1 + h^2, the last by less: (1 + 0.05^2)^251.3 = 1.873
        assertEquals(1.873, energyRatio(), 0.002);
        setStep("0.1");
        runToTheEnd();
        assertEquals(Math.pow(1.01, 125.7), energyRatio(), 0.02);
    }

    @Test
    void aMistakeIsShownAtItsPlaceAndGoesWhenItIsCorrected() {
        page.openScene("02-one-spring");
        edit("solver: rk4", "solver: rk5");
        page.await("the error", () -> page.text("errors").contains("did you mean 'rk4'?"));
        assertStarts(page.text("errors"), "02-one-spring.yaml:9:9: ");
        assertFalse(page.element("start").isEnabled());
        assertEquals(1, page.driver().findElements(org.openqa.selenium.By.className("wrong-place")).size());
        page.screenshot("error");
        edit("solver: rk5", "solver: verlet");
        until("text('errors') === ''");
        runToTheEnd();
        assertEquals("verlet", page.element("solver").getAttribute("value"));
        assertEquals("254", page.text("evaluations"));  // one a step, one more for the first and for the shorter last
    }

    @Test
    void aBlowUpIsToldAndTimeStops() {
        page.openScene("12-stiff-network");
        setStep("0.01");
        page.click("start");
        until("text('message').includes('stopped at t = ')");
        assertHas(page.text("message"), "deltaT");
        String steps = page.text("steps");
        Browser.sleep(500);
        assertEquals(steps, page.text("steps"));
        page.screenshot("blow-up");
    }

    @Test
    void oneStepIsOneStep() {
        page.openScene("02-one-spring");
        page.click("step");
        until("text('steps') === '1'");
        assertEquals("0.05 s", page.text("clock"));
        assertEquals("4", page.text("evaluations"));
        page.click("start");
        until("number('steps') > 2");
        page.script("['restart', 'step'].forEach(id => document.getElementById(id).click());");
        until("text('steps') === '1'");
        assertEquals("Continue", page.text("start"));
    }

    @Test
    void momentsSeenCanBeSeenAgainAndGoneOnFrom() {
        page.openScene("02-one-spring");
        runToTheEnd();
        double end = page.number("clock");
        page.script("const time = document.getElementById('time'); time.value = 3.14;"
                + " time.dispatchEvent(new Event('input'));");
        until("number('clock') < 4");
        assertEquals(3.1, page.number("clock"), 0.011);         // the step before, 62 times 0.05 s
        page.click("start");
        page.await("the end again", () -> page.number("clock") == end);
        assertEquals("252", page.text("steps"));
    }

    @Test
    void anInvalidStepIsRefusedInTheConsolesWordsAndTheLastValidOneStays() {
        page.openScene("02-one-spring");
        setStep("0.1");
        for (String typed : List.of("abc", "-1", "0", "0,05")) {
            page.script("const step = document.getElementById('deltaTNumber'); step.value = arguments[0];"
                    + " step.dispatchEvent(new Event('change'));", typed);
            page.await(typed + " refused", () -> page.text("deltaTError").contains(typed));
            assertEquals("0.1", page.element("deltaTNumber").getAttribute("value"));
        }
        assertEquals("", page.text("message"));
        runToTheEnd();
        assertEquals("126", page.text("steps"));                // 4 pi / 0.1 = 125.7
    }

    @Test
    void plotsShowTheStatesOfStepsAndNothingBetweenThem() {
        page.openScene("02-one-spring");
        page.choose("solver", "euler");
        until("text('sentence').includes('straight')");
        setStep("0.5");
        page.choose("speed", "1");
        page.click("start");
        until("number('steps') >= 5");
        page.click("start");
        assertEquals("Continue", page.text("start"));
        assertEquals(true, page.script("""
                return [window.lab.energy.data[0], window.lab.phase.data[2][0]].every(all => all.length ===
                  Number(document.getElementById('steps').textContent) + 1)
                  && window.lab.energy.data[0].every((time, i) => time === 0.5 * i);
                """));
    }

    @ParameterizedTest
    @EnumSource(names = {"MOUSE", "TOUCH"})
    void aPulledParticleFollowsAndThePullIsInTheWork(Kind kind) {
        page.openScene("02-one-spring");
        hold(kind, 1).moveByOffset(0, -80).perform();
        page.await("the pull's work", () -> page.text("work").matches("(?s).*pointer \\(driven\\): [0-9].*"));
        until("text('forceList').includes('pointer')");
        page.driver().resetInputState();        // lets go
        until("!text('forceList').includes('pointer')");
        page.script("const time = document.getElementById('time'); time.value = 0.1;"
                + " time.dispatchEvent(new Event('input'));");
        until("number('clock') <= 0.1");
        page.click("start");
        until("text('message').includes('without your earlier pulls')");
        until("text('work') === ''");
    }

    @Test
    void longStepsAreShownSmoothly() {
        page.openScene("02-one-spring");
        setStep("2");
        page.choose("speed", "0.1");
        page.click("start");
        until("number('clock') > 0.05");
        assertEquals("1", page.text("steps"));
        assertTrue(page.number("clock") < 2, page.text("clock"));
    }

    @Test
    void aSolverOfOnesOwnRunsAndOneThatIsNotThereIsNamedWithTheCommand() {
        page.openScene("02-one-spring");
        page.choose("solver", Browser.SOLVER);
        until("text('sentence').includes('your own')");
        runToTheEnd();
        assertEquals("504", page.text("evaluations"));  // two a step
        assertEquals(1 + 251.3 * Math.pow(0.05, 4) / 4, energyRatio(), 1e-4);
        edit("solver: rk4", "solver: exercises.Other");
        until("text('errors').includes('gradle lab -Psolver=exercises.Other')");
    }

    @Test
    void anEffectOfOnesOwnActsInASceneAndOneThatIsMissingIsNamedWithTheCommand() {
        page.openScene("01-falling-particle");
        edit("  - gravity ", "  - gravity\n  - exercises.Lift: {acceleration: 9.81} #");
        until("window.lab.view.facts.energies.some(name => name.includes('Lift'))");
        runToTheEnd();
        // Lift cancels gravity: 7 m/s up for 1.5 s from height 0
        assertEquals(10.5, value("window.lab.view.moment.state[1]"), 1e-9);
        edit("exercises.Lift: {acceleration: 9.81}", "exercises.Other: {acceleration: 9.81}");
        until("text('errors').includes('gradle lab')");
        assertHas(page.text("errors"), "exercises.Other");
    }

    @Test
    void anErrorInAClassIsToldInItsOwnWordsAndThePageStaysUsable() {
        page.openScene("01-falling-particle");
        edit("  - gravity ", "  - gravity\n  - exercises.Lift: {acceleration: 2000} #");
        until("window.lab.view.facts.energies.some(name => name.includes('Lift'))");
        page.click("start");
        until("text('message').includes('no wing lifts like that')");
        assertEquals("Start", page.text("start"));
        edit("acceleration: 2000", "acceleration: 9.81");
        until("text('message') === ''");
        runToTheEnd();
        page.choose("scene", "02-one-spring.yaml");
        until("text('steps') === '0'");
        runToTheEnd();
        assertEquals("252", page.text("steps"));
    }

    /** At least 4.5 to 1, as the Web Content Accessibility Guidelines ask of small text. */
    @ParameterizedTest
    @ValueSource(strings = {"light", "dark"})
    void textContrastsWithItsBackground(String scheme) {
        page.driver().executeCdpCommand("Emulation.setEmulatedMedia",
                Map.of("features", List.of(Map.of("name", "prefers-color-scheme", "value", scheme))));
        page.openScene("12-stiff-network");
        edit("solver: rk4", "solver: rk5");                     // errors have colours of their own
        page.await("the error", () -> !page.text("errors").isEmpty());
        assertEquals(List.of(), page.script("""
                const part = c => c <= 10.31475 ? c / 3294.6 : ((c / 255 + 0.055) / 1.055) ** 2.4;
                const channels = colour => colour.match(/[0-9.]+/g).map(Number);
                const luminance = ([r, g, b]) => 0.2126 * part(r) + 0.7152 * part(g) + 0.0722 * part(b);
                const ground = element => {
                  const [r, g, b, a = 1] = channels(getComputedStyle(element).backgroundColor);
                  return a > 0 ? [r, g, b] : element.parentElement ? ground(element.parentElement) : [255, 255, 255];
                };
                return [...document.body.querySelectorAll('*')]
                  .filter(element => element.offsetParent && !element.closest('script, style, [disabled]'))
                  .filter(element => [...element.childNodes].some(node => node.nodeType === 3 && node.data.trim()))
                  .map(element => {
                    const [one, other] = [channels(getComputedStyle(element).color), ground(element)].map(luminance);
                    const contrast = (Math.max(one, other) + 0.05) / (Math.min(one, other) + 0.05);
                    return [contrast, element.tagName + ' ' + element.className + ' ' + element.textContent];
                  })
                  .filter(([contrast]) => contrast < 4.5).map(line => line.join(' ').slice(0, 80));
                """));
        page.screenshot(scheme);
    }

    @Test
    void withoutWebGLTheRestOfThePageWorks() {
        page.driver().executeCdpCommand("Page.addScriptToEvaluateOnNewDocument", Map.of("source", """
                const original = HTMLCanvasElement.prototype.getContext;
                HTMLCanvasElement.prototype.getContext = function (kind, ...more) {
                  return kind.startsWith('webgl') ? null : original.call(this, kind, ...more);
                };
                """));
        page.go(page.driver().getCurrentUrl());
        assertHas(page.text("view"), "no WebGL 2");
        runToTheEnd();
        assertEquals("252", page.text("steps"));
        assertEquals(1, energyRatio(), 1e-5);
    }

    @ParameterizedTest
    @ValueSource(ints = {390, 768, 1280, 1920})
    void nothingIsWiderThanTheWindow(int width) {
        page.driver().executeCdpCommand("Emulation.setDeviceMetricsOverride",
                Map.of("width", width, "height", 900, "deviceScaleFactor", 1, "mobile", false));
        until("innerWidth === " + width + " && document.querySelector('#view canvas').clientWidth"
                + " === element('view').clientWidth");
        assertEquals(0L, page.script(
                "const all = document.documentElement; return all.scrollWidth - all.clientWidth;"));
        assertEquals(true, page.script("""
                const {clientWidth, clientHeight} = document.getElementById('view');
                return window.lab.view.structure.ids.map((id, i) => window.lab.view.onScreen(i))
                  .every(([x, y]) => x > 0 && x < clientWidth && y > 0 && y < clientHeight);
                """), "all particles are in the picture");
        page.screenshot("width-" + width);
    }

    @Test
    void everyControlHasANameAndIsReachedByTab() {
        assertEquals(List.of(), page.script("""
                return [...document.querySelectorAll('button, input, select, textarea, [tabindex]')]
                  .filter(element => element.offsetParent && !element.closest('.CodeMirror'))
                  .filter(element => element.tabIndex < 0 || !element.labels?.length
                    && !element.getAttribute('aria-label') && !element.textContent.trim())
                  .map(element => element.outerHTML.slice(0, 100));
                """));
    }

    @Test
    void thePageIsSmallAndTellsItsLicences() throws IOException {
        Path file = Browser.page();
        assertBelow(3_000_000, Files.size(file));
        String text = Files.readString(file);
        for (String word : List.of("three.js", "uPlot", "CodeMirror", "snakeyaml-engine", "EJML", "TeaVM",
                "Apache License", "Version 2.0, January 2004", "MIT")) {
            assertTrue(text.contains(word), word);
        }
        assertFalse(text.contains("src=\"http") || text.contains("import(\"http"), "it loads something from elsewhere");
    }

    /** Worms, a caterpillar, a walker, a page, and bodies that orbit: all are dragged by the particle that is seen. */
    @ParameterizedTest
    @ValueSource(strings = {"49-creeping-worm", "50-serpent", "51-caterpillar", "52-walker", "53-turning-page",
            "54-three-bodies", "55-magnetic-bottle", "56-four-masses"})
    void creaturesFollowTheMouse(String scene) {
        page.openScene(scene);
        until("view.moment && view.structure");
        int seen = (int) value("""
                view.structure.ids.findIndex((id, i) => {
                  const {left, top, width, height} = element('view').getBoundingClientRect();
                  const [x, y] = view.onScreen(i) ?? [-1, -1];
                  return x > 30 && y > 90 && x < width - 30 && y < height - 30
                    && view.nearest({clientX: left + Math.floor(x), clientY: top + Math.floor(y)}, 14) === i;
                })""");
        hold(Kind.MOUSE, seen).moveByOffset(0, -60).perform();
        page.await("the pull's work", () -> page.text("work").matches("(?s).*pointer \\(driven\\): -?[0-9].*"));
        until("(([x, y], [a, b]) => Math.hypot(x - a, y - b))(view.onScreen(" + seen
                + "), view.camera.placeOf(view.pull.point)) < 42");
        page.driver().resetInputState();        // lets go
        until("!view.pull && number('steps') > 0");
        assertEquals("", page.text("message"));
    }
}
