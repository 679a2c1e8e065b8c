package browser;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** Any quantity over any other, and what the page reads off it. */
class LabCurvesTest extends LabPageTestCase {

    @Test
    void periodAndAmplitudeAreReadOffACurveOverTime() {
        page.openScene("02-one-spring");
        assertEquals("", page.text("period"));
        page.choose("horizontal", "time (s)");
        page.choose("vertical", "vx (m/s)");
        runToTheEnd();
        // omega = 1 and rk4's steps of 0.05 s: the period is wrong by (omega h)^4 / 120
        until("text('period').endsWith('period 6.283 s, amplitude 1 m/s')");
        // the marks: where it is, the maxima at 3 pi / 2 and 7 pi / 2, and the minimum between them
        assertEquals(4, value("phase.data[3][0].length"));
        assertEquals(3 * Math.PI / 2, value("phase.data[3][0][1]"), 1e-4);
        assertEquals(-1, value("phase.data[3][1][2]"), 1e-4);
        assertEquals(7 * Math.PI / 2, value("phase.data[3][0][3]"), 1e-4);
        page.screenshot("period");
    }

    @Test
    void severalQuantitiesAreDrawnTogether() {
        page.openScene("02-one-spring");
        page.choose("horizontal", "time (s)");
        page.choose("vertical", "x (m)");
        page.click("addCurve");
        page.choose("vertical", "distance to wall (m)");
        page.click("addCurve");
        page.choose("vertical", "kinetic (J)");
        runToTheEnd();
        // x = cos t, the wall is at -2, the mass 1 kg
        until("phase.curves[0].length === 5 && phase.curves[0][0].length === 253");
        assertEquals(0, value("Math.max(...phase.curves[0][1].map((t, k) => Math.abs(t - phase.curves[0][0][k])))"));
        assertEquals(0, value("Math.max(...phase.curves[0][3].map((x, k) =>"
                + " Math.abs(x - Math.cos(phase.curves[0][1][k]))))"), 1e-5);
        assertEquals(0, value("Math.max(...phase.curves[0][4].map((far, k) =>"
                + " Math.abs(far - 2 - phase.curves[0][3][k])))"), 1e-5);
        assertEquals(0, value("Math.max(...phase.curves[0][2].map((joules, k) =>"
                + " Math.abs(joules - Math.sin(phase.curves[0][1][k]) ** 2 / 2)))"), 1e-5);
        assertTrue(page.element("oneCurve").isDisplayed());
        page.screenshot("curves");
        Object link = page.later("window.lab.address.write().then(arguments[0]);");
        page.go((String) link);
        until("phase.curves?.[0].length === 5 && value('vertical') === 'kinetic (J)'");
        page.click("oneCurve");
        until("phase.curves[0].length === 3");
        assertFalse(page.element("oneCurve").isDisplayed());
    }
}
