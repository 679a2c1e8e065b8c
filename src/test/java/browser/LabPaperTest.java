package browser;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** The page on paper and on a phone. */
class LabPaperTest extends LabPageTestCase {
    private static final String SEEN = "return [...document.querySelectorAll('button, input[type=range], summary,"
            + " #arrows')].filter(one => one.offsetParent && one.offsetHeight > 0).map(one => one.id);";

    @Test
    void printingLeavesOutWhatIsPressed() {
        page.openScene("02-one-spring");
        runToTheEnd();
        page.driver().executeCdpCommand("Emulation.setEmulatedMedia", Map.of("media", "print"));
        page.driver().executeCdpCommand("Emulation.setDeviceMetricsOverride", Map.of("width", 800, "height", 1100,
                "deviceScaleFactor", 1, "mobile", false));
        assertEquals(List.of(), page.script(SEEN));
        assertEquals(true, page.script("return document.querySelector('#view').offsetHeight"
                + " === document.querySelector('#views').offsetHeight;"));
        assertEquals("auto", page.script("return getComputedStyle(document.body).height === innerHeight + 'px'"
                + " ? 'one window' : 'auto';"));
        assertEquals(true, page.script("return ['view', 'clock', 'solver', 'deltaTNumber', 'energy', 'phase'].every("
                + "id => document.getElementById(id).offsetHeight > 0);"));
    }

    @Test
    void checkBoxesAreLargeEnoughForAFingerOnAPhone() {
        page.driver().executeCdpCommand("Emulation.setDeviceMetricsOverride", Map.of("width", 390, "height", 800,
                "deviceScaleFactor", 2, "mobile", true));
        assertEquals(List.of(24L, 24L, 24L), page.script("return ['arrows', 'forces', 'labels'].map(id =>"
                + " document.getElementById(id).offsetWidth);"));
    }
}
