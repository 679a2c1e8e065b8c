package browser;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.openqa.selenium.Keys;

/** What people type: other values for keys of a scene, in the grammar of the console, in a field or in the address. */
class SettingsInThePageTest extends LabPageTestCase {
    private static final String MOON = "springs[0].damping=0.5, effects.gravity.acceleration=[0, -1.62, 0]";

    private void type(String settings) {
        page.element("set").clear();
        page.element("set").sendKeys(settings, Keys.ENTER);
    }

    /** At rest from the start: x'' = -g. */
    @Test
    void aTypedAddressOpensASceneWithItsSettings() {
        page.go(Browser.page().toUri() + "#scene=1&solver=verlet&deltaT=0.1&set=duration=0.5,"
                + "effects.gravity.acceleration=[0, -1.62, 0],particles.stone.velocity=[0,0,0]");
        until("view.facts.title === 'A falling particle' && view.facts.duration === 0.5");
        double height = value("state[1]");
        runToTheEnd();
        assertEquals("5", page.text("steps"));
        assertEquals("verlet", page.element("solver").getAttribute("value"));
        assertEquals(height - 1.62 * 0.25 / 2, value("state[1]"), 1e-6);
        until("location.hash.startsWith('#scene=01-falling-particle&solver=verlet&deltaT=0.1&set=duration=0.5,')");
        String link = page.driver().getCurrentUrl();
        page.script("location.href = arguments[0];", link.replace("solver=verlet", "solver=euler"));
        until("value('solver') === 'euler' && view.facts.duration === 0.5");
        page.script("location.href = arguments[0];", link.replace("scene=01-falling-particle", "scene=77"));
        until("text('note').includes('damaged')");
    }

    @ParameterizedTest
    @CsvSource(delimiter = ';', value = {"solver=foo; foo", "solver=foo&deltaT=abc; deltaT",
        "set=springs[9].damping=1; [9]"})
    void ofAnAddressWithWrongSettingsTheSceneIsOpenedWithItsOwn(String settings, String wrong) {
        page.go(Browser.page().toUri() + "#scene=2&" + settings);
        until("text('note').includes('" + wrong + "')");
        assertEquals(List.of("rk4", "0.05", "", ""), page.script("""
                return [...['solver', 'deltaTNumber', 'set'].map(id => document.getElementById(id).value),
                  document.getElementById('message').textContent];"""));
        page.click("start");
        until("number('steps') > 0");
    }

    @Test
    void theFieldTakesWhatTheConsoleTakesAndSaysItsWords() {
        page.openScene("02-one-spring");
        type(MOON);
        until("view.facts.energies.includes('gravity')");
        until("![...document.querySelectorAll('#parameters label')].some("
                + "one => one.textContent.startsWith('gravity'))");
        type("springs[9].damping=1");
        until("text('setError') === 'springs[9].damping: [9] does not exist; the last one is [0]'");
        assertEquals("", page.text("errors"));
        assertEquals("true", page.element("set").getAttribute("aria-invalid"));
        type("duration=2");
        until("view.facts.duration === 2 && text('setError') === ''");
        type("");
        until("view.facts.duration > 12");
    }
}
