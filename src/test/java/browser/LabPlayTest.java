package browser;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;

/** The scene's numbers on sliders, and files of what was seen and computed. */
class LabPlayTest extends LabPageTestCase {

    /** Moves a slider of the scene's numbers to a part of its way, and waits until the scene has the new number. */
    private double slide(String label, double part) {
        until("[...document.querySelectorAll('#parameters label')].map(one => one.textContent)"
                + ".some(text => text.startsWith('" + label + "'))");
        page.script("""
                window.before = window.lab.view.facts;
                const input = [...document.querySelectorAll('#parameters label')]
                  .find(one => one.textContent.startsWith(arguments[0])).querySelector('input');
                input.value = arguments[1] * input.max;
                input.dispatchEvent(new Event('input'));
                """, label, part);
        until("view.facts !== window.before");
        return ((Number) page.script("""
                return parseFloat([...document.querySelectorAll('#parameters label')]
                  .find(one => one.textContent.startsWith(arguments[0])).querySelector('output').textContent);
                """, label)).doubleValue();
    }

    @Test
    void slidersWriteTheScenesNumbersIntoItsText() {
        page.openScene("02-one-spring");
        double stiffness = slide("stiffness", 0.65);            // 20^0.3 = 2.46
        assertEquals(2.46, stiffness);
        until("scene().includes('stiffness: 2.46')");
        runToTheEnd();
        // of rk4's phase, (omega h)^4 / 120 is wrong: 6e-6 of 20
        assertEquals(Math.cos(Math.sqrt(stiffness) * 4 * Math.PI), value("state[6]"), 4e-5);
        page.openScene("01-falling-particle");
        double gravity = slide("gravity", 0.53);                // from -25 to 25
        assertEquals(1.5, gravity);
        until("scene().includes('- gravity: {acceleration: [0, -1.5, 0]}')");
        runToTheEnd();
        assertEquals(7 * 1.5 - 1.5 / 2 * 1.5 * 1.5, value("state[1]"), 1e-6);
        assertEquals(0, slide("gravity", 0.5));
        page.openScene("49-creeping-worm");
        assertEquals(0.25, slide("amplitude", 0.25));           // from 0 to 1, of all muscles together
        assertEquals(1.2, slide("wavelength", 0.5));
        double period = slide("period", 0.6);                   // 20^0.2
        assertEquals(1.82, period);
        until("scene().split('amplitude: 0.25, period: 1.82, wavelength: 1.2').length === 3");
        page.openScene("07-sliding-friction");
        assertEquals(1, slide("restitution", 1));               // no more than the scene's format allows
    }

    @Test
    void theStiffestVibrationMovesInTheStabilityRegionWithDeltaT() {
        page.openScene("02-one-spring");
        page.script("document.getElementById('stability').open = true;");
        until("text('growth') === 'h λ = 0 ± 0.05 i: each step keeps its size.'");
        page.script("const slider = document.getElementById('deltaT'); slider.value = Math.log10(2.9);"
                + " slider.dispatchEvent(new Event('input'));");
        page.await("growth beyond 2.83", () -> page.text("growth").startsWith("h λ = 0 ± 2.9 i: ")
                && page.text("growth").endsWith("so it grows."));
        page.choose("solver", "euler");
        // sqrt(1 + 0.05^2) = 1.00125
        until("text('growth').includes('by 1 + 0.00125, so it grows')");
        page.choose("solver", Browser.SOLVER);                  // Heun: sqrt(1 + h^4 / 4)
        setStep("0.5");
        until("text('growth').includes('by 1 + 0.00778, so it grows')");
        page.await("the region", () -> (Boolean) page.script("""
                const canvas = document.getElementById('region'), {width, height} = canvas;
                return canvas.getContext('2d').getImageData(0.6 * width, 0.55 * height, 1, 1).data[3] > 0;
                """));
        page.choose("solver", Browser.UNFINISHED);
        until("text('growth') === 'exercises.UnfinishedSolver cannot be tried: the second half is yet to be written'");
        page.choose("solver", "rk4");
        until("text('growth').includes('h λ = 0 ± 0.5 i: each step')");
        page.openScene("01-falling-particle");
        assertFalse(page.element("stability").isDisplayed());
    }

    @Test
    void runsBesideTheFirstFollowItsTimeAndAreOverlaid() {
        page.openScene("02-one-spring");
        page.click("addPanel");
        until("caption() === 'euler, deltaT = 0.05 s: 0 s, 0 evaluations'");
        runToTheEnd();
        until("caption().endsWith(': 12.57 s, 252 evaluations')");
        until("phase.data[4][0].length === 253");
        page.choose("horizontal", "time (s)");
        page.choose("vertical", "total (J)");
        until("phase.data[4][0].length === 253");
        assertEquals(Math.pow(1.0025, 251.3) / 2, value("phase.data[4][1].at(-1)"), 1e-3);
        page.script("const time = document.getElementById('time'); time.value = 3;"
                + " time.dispatchEvent(new Event('input'));");
        until("caption().endsWith(': 3 s, 60 evaluations') && number('evaluations') === 240");
        page.screenshot("compare");
        page.choose("equalWork", "on");
        until("caption().startsWith('euler, deltaT = 0.0125 s: 0 s')");
        runToTheEnd();
        until("caption().endsWith(': 12.57 s, 1006 evaluations')");     // 4 pi / 0.0125 = 1005.3
        page.script("const time = document.getElementById('time'); time.value = 3;"
                + " time.dispatchEvent(new Event('input'));");
        until("text('clock') === '3 s'");
        page.click("copyLink");
        until("text('note').includes('link is in the')");
        page.go(page.driver().getCurrentUrl());
        until("caption() === 'euler, deltaT = 0.0125 s: 3 s, 240 evaluations'");
        page.choose("solver", "radau");
        until("text('panelList').includes('No fixed number of evaluations')");
        page.script("const equal = document.getElementById('equalWork'); equal.value = '';"
                + " equal.dispatchEvent(new Event('change'));"              // at once, as on a busy machine
                + " const step = document.querySelector('#panelList input'); step.value = '0,5';"
                + " step.dispatchEvent(new Event('change'));");
        until("text('panelList').includes('a decimal point, not a comma')");
        page.script("document.querySelector('#panelList button').click();");
        until("!document.querySelector('figure')");
    }

    @Test
    void aRunBesideTheFirstMayHaveItsOwnText() {
        page.openScene("02-one-spring");
        page.click("addPanel");
        until("caption().startsWith('euler, deltaT = 0.05 s')");
        page.click("showEditor");
        page.choose("textOf", "1");
        edit("solver: rk4", "solver: adams");
        until("caption() === 'adams, deltaT = 0.05 s: 0 s, 0 evaluations, own text'");
        assertEquals(3.97, slide("stiffness", 0.731));          // 20^0.46 = 3.97
        until("caption().startsWith('adams') && scene().includes('stiffness: 3.97')");
        runToTheEnd();
        until("caption().includes(': 12.57 s, ')");
        // the first has omega = 1, the other sqrt(3.97)
        assertEquals(Math.cos(4 * Math.PI), value("state[6]"), 1e-4);
        assertEquals(Math.cos(Math.sqrt(3.97) * 4 * Math.PI),
                value("window.lab.panels.all[0].view.moment.state[6]"), 0.01);
        assertFalse(page.element("nearestSection").isDisplayed());      // only one has the scene
        page.choose("equalWork", "on");                         // 2 evaluations per step, and rk4's 4
        until("caption().startsWith('adams, deltaT = 0.025 s')");
        page.choose("equalWork", "");
        page.choose("textOf", "0");
        until("scene().includes('stiffness: 1 ')");
        edit("duration: ", "duration: 3 #");
        until("view.facts.duration === 3 && window.lab.panels.all[0].facts?.duration > 12");
        page.click("copyLink");
        until("text('note').includes('link is in the')");
        page.go(page.driver().getCurrentUrl());
        until("caption().endsWith(', own text') && view.facts.duration === 3");
        page.choose("textOf", "1");
        until("scene().includes('stiffness: 3.97')");
        edit("stiffness: 3.97", "stiffness: no");
        until("text('errors').includes('stiffness') && text('panelList').includes('stiffness')");
        page.openScene("06-bouncing-ball");
        until("!caption().endsWith('own text') && !text('errors')");
    }

    @Test
    void theRunNearestToTheReferenceIsNamedWhereThatIsClear() {
        page.openScene("02-one-spring");
        page.click("addPanel");
        until("caption().startsWith('euler')");
        until("text('nearest').startsWith('Mean distance over 12.57 s: rk4 (run 1) ')");
        assertTrue(page.text("nearest").matches(
                ".* Nearest: rk4 \\(run 1\\); euler \\(run 2\\) is [0-9e+.]+ times as far\\."));
        // each of Euler's steps multiplies the amplitude by sqrt(1 + h^2) and turns by atan(h); one of two moves
        double mean = 0;
        for (int k = 0; k <= 200; k++) {
            double t = k * 4 * Math.PI / 200;
            double steps = t / 0.05;
            mean += Math.abs(Math.pow(1 + 0.0025, steps / 2) * Math.cos(steps * Math.atan(0.05)) - Math.cos(t))
                    / Math.sqrt(2) / 201;
        }
        assertEquals(mean, Double.parseDouble(page.text("nearest")
                .replaceFirst(".*euler \\(run 2\\) ([0-9.]+) m.*", "$1")), 0.05 * mean);
        assertEquals(200, value("window.lab.distances.data[2][0].length"));     // all but the start, 0 on the axis
        setStep("0.2");
        page.script("document.querySelector('#panelList select').value = 'rk4';"
                + " document.querySelector('#panelList select').dispatchEvent(new Event('change'));");
        until("caption().startsWith('rk4, deltaT = 0.2 s')");
        until("text('nearest').endsWith('No clear difference.')");
        page.screenshot("nearest");
    }

    @Test
    void aChaoticMotionIsNamedWhereTwoReferencesPart() {
        page.openScene("41-double-pendulum");
        page.click("addPanel");
        until("text('nearest').endsWith('m apart: this motion magnifies small errors.')");
        // in Java 0.235 m after 15 s; of a regular scene's motion, at most 2e-6
        double apart = Double.parseDouble(page.text("nearest").replaceFirst(".*end ([0-9.]+) m apart.*", "$1"));
        assertTrue(apart > 0.02 && apart < 2.6, () -> apart + " m");
    }

    @Test
    void pictureTableAndFilmAreSaved() {
        page.script("window.saved = {}; HTMLAnchorElement.prototype.click = function () {"
                + " fetch(this.href).then(file => file.blob())"
                + ".then(blob => { window.saved[this.download] = blob; }); };"
                + " document.querySelector('details.beside').open = true;");
        page.openScene("14-thrown-dumbbell");
        page.click("film");
        page.script("const {width, height} = document.querySelector('#view canvas'); window.filmed = [width, height];");
        runToTheEnd();
        page.click("film");
        for (String button : List.of("savePicture", "saveEnergy", "savePhase", "saveTable")) {
            page.click(button);
        }
        until("Object.keys(window.saved).length === 5");
        assertEquals(List.of(), page.later("""
                const [done] = arguments, name = end => window.saved['14-thrown-dumbbell-verlet' + end];
                const isNamed = plot => {
                  const c = Object.assign(document.createElement('canvas'), {width: 400, height: 30}).getContext('2d');
                  c.drawImage(plot, 0, 30 - plot.height);
                  return c.getImageData(0, 0, 400, 30).data.some((value, i) => i % 4 === 0 && value < 100);
                };
                Promise.all([createImageBitmap(name('.png')), createImageBitmap(name('-energy.png')),
                  createImageBitmap(name('-phase.png')), name('.csv').text(), name('.webm').arrayBuffer()])
                  .then(([picture, energy, phase, table, film]) => {
                    const rows = table.trim().split('\\n'), last = rows.at(-1).split(',').map(Number);
                    const right = {
                      picture: [picture.width, picture.height].join() === '1920,1080',
                      filmed: window.filmed.join() === '1920,1080',
                      again: document.querySelector('#view canvas').width < 1200,
                      plots: [energy, phase].every(plot => plot.width === 1920 && plot.height > 600)
                        && document.querySelector('#energy canvas').width < 900,
                      named: [energy, phase].every(isNamed),
                      head: rows[0].startsWith('time (s),total (J),kinetic (J),'),
                      rows: rows.length === 2 + Number(document.getElementById('steps').textContent),
                      time: Math.abs(last[0] - 1.6) < 1e-12,
                      x: Math.abs(last[6] - window.lab.view.moment.state[0]) < 1e-6,
                      film: new DataView(film).getUint32(0) === 0x1A45DFA3 && film.byteLength > 3000
                    };
                    done(Object.keys(right).filter(name => !right[name]));
                  });
                """));
    }

    @Test
    void theEquationsOfTheScenesForcesAreTypesetWithTheirNumbers() {
        page.openScene("05-hanging-chain");
        assertEquals(List.of("springs", "gravity", "drag", "rk4"), page.script(
                "return [...document.querySelectorAll('#equations h2')].map(one => one.textContent);"));
        assertEquals(List.of("F = m g", "acceleration = (0, -9.81, 0) m/s²"), page.script("""
                const head = [...document.querySelectorAll('#equations h2')].find(one => one.textContent === 'gravity');
                const [formula, numbers] = [head.nextSibling, head.nextSibling.nextSibling];
                return [formula.querySelector('math').textContent, numbers.textContent];
                """));
        until("element('equations').textContent.includes('k = 1000 N/m, l = 0.08333 m, k_d = ')");
        until("!element('equations').textContent.includes('quadraticDrag')");
        until("document.querySelector('#equations msub').textContent === 'xj'");
        until("document.querySelector('#equations pre').textContent.includes('| 1/6  1/3  1/3  1/6')");
        page.choose("solver", "verlet");
        until("document.querySelector('#equations pre').textContent.startsWith('v(t + h/2) = v(t) + h/2 a(')");
        page.openScene("49-creeping-worm");             // two muscles: one formula, and each one's numbers
        until("[...document.querySelectorAll('#equations h2')].filter(({textContent}) => textContent === 'muscles')"
                + ".length === 1 && [...document.querySelectorAll('#equations .soft')]"
                + ".filter(({textContent}) => textContent.includes('wavelength')).length === 2");
    }

    @Test
    void gravityIsChosenByItsPlaceAndEnergiesOfTheMomentAreBars() {
        page.openScene("01-falling-particle");
        for (String place : List.of("24.79", "0", "1.62")) {
            page.script("""
                    window.before = window.lab.view.facts;
                    const list = document.querySelector('#parameters select'); list.value = arguments[0];
                    list.dispatchEvent(new Event('change'));
                    """, place);
            until("view.facts !== window.before && document.querySelector('#parameters select').value === '" + place
                    + "'");
        }
        until("scene().includes('- gravity: {acceleration: [0, -1.62, 0]}')");
        runToTheEnd();
        // 58/2 J of motion at the start; at the end v_y = 7 - 1.62 1.5, and its loss is gravity's gain
        double kinetic = (9 + Math.pow(7 - 1.62 * 1.5, 2)) / 2;
        until("element('bars').textContent === 'total 29 Jkinetic " + String.format("%.1f", kinetic) + " Jgravity "
                + String.format("%.1f", 29 - kinetic) + " J'");
        assertEquals(kinetic / 29, value("document.querySelectorAll('#bars span')[1].offsetWidth"
                + " / element('bars').offsetWidth"), 0.005);
        page.script("const time = document.getElementById('time'); time.value = 0;"
                + " time.dispatchEvent(new Event('input'));");
        until("element('bars').textContent === 'total 29 Jkinetic 29 Jgravity 0 J'");
    }
}
