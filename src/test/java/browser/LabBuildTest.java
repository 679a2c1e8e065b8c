package browser;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.openqa.selenium.Keys;
import org.openqa.selenium.interactions.Actions;
import org.openqa.selenium.interactions.PointerInput.Kind;

/** Building with the mouse or a finger: the scene's text says what was built, and the run is that of the text. */
class LabBuildTest extends LabPageTestCase {
    private String scene() {
        return (String) page.script("return document.querySelector('.CodeMirror').CodeMirror.getValue();");
    }

    /** Waits until the scene has a text, and the picture shows it at rest at its start. */
    private void untilBuilt(String text) {
        page.await("the text " + text, () -> scene().equals(text));
        until("view.facts !== window.before && view.moment.time === 0 && view.structure.ids.length > 0"
                + " && !view.stale && text('message') === ''");
        page.script("window.before = window.lab.view.facts;");
    }

    private void startBuilding() {
        page.script("window.before = window.lab.view.facts;");
        page.click("build");
        until("view.facts !== window.before && value('time') === '0' && !view.stale");
        page.script("window.before = window.lab.view.facts;");
    }

    private void clickAt(Kind kind, double right, double down) {
        new Actions(page.driver()).setActivePointer(kind, "pointer").moveToLocation(
                (int) value("element('view').getBoundingClientRect().left + " + right + " * view.element.clientWidth"),
                (int) value("element('view').getBoundingClientRect().top + " + down + " * view.element.clientHeight"))
                .click().perform();
    }

    private void drag(Kind kind, int from, int to) {
        String place = "view.onScreen(" + to + ")";
        hold(kind, from).moveByOffset(0, -20).moveToLocation(
                (int) value("element('view').getBoundingClientRect().left + " + place + "[0]"),
                (int) value("element('view').getBoundingClientRect().top + " + place + "[1]")).release().perform();
    }

    @ParameterizedTest
    @EnumSource(names = {"MOUSE", "TOUCH"})
    void massesSpringsAndMusclesGoIntoTheTextAndRun(Kind kind) {
        page.openScene("04-pendulum");
        page.choose("solver", "verlet");
        until("view.facts.solver === 'verlet'");
        String text = scene();
        startBuilding();
        String pose = "return window.lab.view.camera.pose().map(one => one.toFixed(9)).join();";
        clickAt(kind, 0.75, 0.3);
        page.await("the mass", () -> scene().contains("  - {id: m1, position: ["));
        String mass = scene().replaceAll("(?s).*(  - \\{id: m1, position: \\[[-0-9.]+, [-0-9.]+, 0]}\n).*", "$1");
        String placed = text.replaceAll("(.*id: bob.*\n)", "$1" + mass);
        untilBuilt(placed);
        assertEquals(List.of("pivot", "bob", "m1"), page.script("return window.lab.view.structure.ids;"));
        // where it was clicked, to a centimetre
        assertEquals(0.75, value("view.onScreen(2)[0] / view.element.clientWidth"), 0.01);
        assertEquals(0.3, value("view.onScreen(2)[1] / view.element.clientHeight"), 0.01);

        Object camera = page.script(pose);
        drag(kind, 0, 2);
        String joined = placed.replaceAll("(.*stiffness: 10000.*\n)",
                "$1  - {from: pivot, to: m1, stiffness: 100, damping: 1}\n");
        untilBuilt(joined);
        page.choose("between", "muscle");
        drag(kind, 2, 0);
        String muscle = joined.replace("  - gravity\n",
                "  - gravity\n  - muscles: {amplitude: 0.2, period: 1, springs: [{from: m1, to: pivot}]}\n");
        untilBuilt(muscle);
        assertEquals(camera, page.script(pose));
        assertEquals("verlet", page.element("solver").getAttribute("value"));
        page.screenshot("build-" + kind);

        page.click("start");                                    // that ends building
        until("number('steps') > 3 && element('building').hidden");
        page.click("start");
        assertTrue(value("view.structure.springs.length") == 4 && value("state[13]") < value("parseFloat('"
                + mass.replaceAll(".*\\[[-0-9.]+, ([-0-9.]+),.*\n", "$1") + "')"), "it falls");
        startBuilding();
        page.click("undo");
        untilBuilt(joined);
        page.click("undo");
        untilBuilt(placed);
        page.click("undo");
        untilBuilt(text);
        assertEquals("verlet", page.element("solver").getAttribute("value"));
    }

    @Test
    void theChosenMassIsFixedFreedAndDeletedAndAllIsUndoneByKeys() {
        page.openScene("56-four-masses");
        String text = scene();
        startBuilding();
        hold(Kind.MOUSE, 3).release().perform();                // the top
        until("value('particle') === 'top' && view.chosen === 'top'");
        page.click("toggleFixed");
        String fixed = text.replace("[0, 0.5, 0], mass: 0.5}", "[0, 0.5, 0], mass: 0.5, fixed: true}");
        untilBuilt(fixed);
        assertEquals(1, value("view.structure.fixed[3]"));
        hold(Kind.MOUSE, 0).release().perform();
        until("value('particle') === 'left'");
        hold(Kind.MOUSE, 3).release().perform();                // a fixed one can be chosen, too
        until("value('particle') === 'top'");
        page.click("toggleFixed");
        untilBuilt(fixed.replace("fixed: true", "fixed: false"));
        page.click("remove");
        untilBuilt(fixed.replaceAll(".*\\btop\\b.*\n", "").replace("faces:\n\n", ""));
        for (int i = 0; i < 3; i++) {
            until("view.structure && !view.stale");
            String before = scene();
            new Actions(page.driver()).keyDown(Keys.CONTROL).sendKeys("z").keyUp(Keys.CONTROL).perform();
            page.await("the text before", () -> !scene().equals(before));
        }
        untilBuilt(text);
        new Actions(page.driver()).keyDown(Keys.CONTROL).keyDown(Keys.SHIFT).sendKeys("z").keyUp(Keys.SHIFT)
                .keyUp(Keys.CONTROL).perform();
        untilBuilt(fixed);                                      // made again
        page.click("undo");
        untilBuilt(text);
        page.click("undo");
        assertEquals(text, scene());
    }

    @Test
    void whatIsLeftOfASceneIsReadByTheReaderAndAShapesParticlesAreNamed() {
        page.openScene("01-falling-particle");
        String text = scene();
        startBuilding();
        page.click("remove");
        until("text('errors').includes('the scene has no particle')");
        clickAt(Kind.MOUSE, 0.2, 0.2);                          // the picture is not of this text
        page.click("undo");
        untilBuilt(text);
        page.openScene("05-hanging-chain");
        startBuilding();
        page.click("toggleFixed");
        until("text('note') === 'chain[24] is one of a shape; the scene file says which of them are fixed.'");
        drag(Kind.MOUSE, 24, 12);
        page.await("the spring", () -> scene().endsWith(
                "\nsprings:\n  - {from: \"chain[24]\", to: \"chain[12]\", stiffness: 100, damping: 1}\n"));
    }
}
