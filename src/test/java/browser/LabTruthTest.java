package browser;

import static deSolvers.problems.Bounds.assertBelow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Texts.assertHas;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.openqa.selenium.interactions.PointerInput.Kind;

/** What the page shows of runs that fail, go on, take long, or are pulled: it agrees with what was computed. */
class LabTruthTest extends LabPageTestCase {

    /** The clock stops at the message's time; before that, the last steps were seen, and all of them in the picture. */
    @ParameterizedTest
    @CsvSource({"12-stiff-network, rk4, 0.01, 0.03", "02-one-spring, rk4, 10, 10",
            "09-cloth-in-wind, euler, 0.002, 0.074"})
    void aRunThatFailsIsSeenToItsEnd(String scene, String solver, String deltaT, String end) {
        page.openScene(scene);
        page.choose("solver", solver);
        until("view.facts.solver === '" + solver + "'");
        setStep(deltaT);
        page.script("""
                window.seen = [];
                const {view} = window.lab, draw = view.draw;
                view.draw = () => {
                  const drawn = draw.call(view);
                  if (drawn && view.moment.slowed) {
                    const places = view.structure.ids.map((id, i) => view.onScreen(i) ?? [Infinity, Infinity]);
                    const spread = axis => Math.max(...places.map(place => place[axis]))
                      - Math.min(...places.map(place => place[axis]));
                    window.seen.push([view.moment.time, Math.max(...places.map(([x]) =>
                      Math.abs(2 * x / view.element.clientWidth - 1))),
                      Math.max(spread(0), spread(1)) / view.element.clientHeight]);
                  }
                  return drawn;
                };
                """);
        page.click("start");
        until("text('message').startsWith('This run fails')");
        until("text('message').startsWith('" + solver + " stopped at t = " + end + " s')");
        assertEquals(end + " s", page.text("clock"));
        assertEquals("Start", page.text("start"));
        double last = Double.parseDouble(end);
        // of four seconds, at least this many pictures, in the order of time; in each, particles far apart
        assertEquals(true, page.script("return window.seen.length >= 5 && window.seen.every(([time, across, part], k)"
                + " => across <= 1 && part > 0.2 && time < arguments[0]"
                + " && (k === 0 || time >= window.seen[k - 1][0]));", last),
                () -> "" + page.script("return window.seen;"));
        page.screenshot("failed-" + scene);
        page.click("restart");
        until("text('steps') === '0' && text('message') === ''");
    }

    @Test
    void aRunStillMovesAfterFourChangesAndAfterAMistakeAndItsMend() {
        page.openScene("02-one-spring");
        page.click("start");
        until("number('steps') > 0");
        page.script("""
                const solver = document.getElementById('solver');
                for (const name of ['euler', 'midpoint', 'verlet', 'rk4']) {
                  solver.value = name;
                  solver.dispatchEvent(new Event('change'));
                }
                """);
        until("view.facts.solver === 'rk4' && text('start') === 'Pause' && number('steps') > 0");
        edit("solver: rk4", "solver: rk5");
        page.await("the error", () -> page.text("errors").contains("did you mean 'rk4'?"));
        edit("solver: rk5", "solver: verlet");
        until("view.facts.solver === 'verlet' && text('start') === 'Pause' && number('steps') > 0");
    }

    @Test
    void aRunGoesOnBeyondTheScenesDurationOrBeginsAgain() {
        page.openScene("02-one-spring");
        edit("duration: ", "duration: 1.01 #");
        until("view.facts.duration === 1.01");
        page.choose("speed", "5");
        page.click("start");
        until("number('clock') > 3.5");
        page.click("start");
        until("text('start') === 'Continue'");
        double clock = page.number("clock");            // of four digits
        // rk4's energy error: 5e-7 in 12.6 s; on a busy machine the run goes on for longer
        assertEquals(1, energyRatio(), 8e-8 * clock);
        assertTrue(value("Number(element('time').max)") >= 0.999 * clock);
        page.choose("horizontal", "time (s)");          // and so does the reference
        until("Math.max(...phase.data[1][0]) > 3");
        page.choose("atEnd", "loop");
        page.click("restart");
        page.script("window.turns = 0; window.last = 0; new MutationObserver(() => {"
                + " const now = parseFloat(document.getElementById('clock').textContent);"
                + " window.turns += now < window.last ? 1 : 0; window.last = now;"
                + " }).observe(document.getElementById('clock'), {childList: true});");
        page.click("start");
        until("window.turns > 2 && text('start') === 'Pause' && number('clock') <= 1.01");
    }

    @Test
    void whatSomebodyPullsIsWorkAndNoNumericalError() {
        page.openScene("02-one-spring");
        setStep("0.01");
        hold(Kind.MOUSE, 1).moveByOffset(0, -80).perform();
        until("number('clock') > 0.5");
        page.driver().resetInputState();
        until("number('clock') > 1");
        page.click("start");
        until("text('start') === 'Continue'");
        double error = value("Math.max(...energy.data.at(-1).map(Math.abs))");
        double work = value("Math.max(...energy.data[1]) - energy.data[1][0]");
        assertTrue(work > 0.1, () -> work + " J");
        // of rk4 itself, with the pointer's spring of up to 12 rad/s: (omega h)^5 in each step
        assertBelow(1e-3 * work, error);
    }

    @Test
    void aStepThatTakesLongIsToldAndThePageStaysUsable() {
        page.openScene("02-one-spring");
        page.script("window.lab.player.tell({type: 'run', milliseconds: 20000});");
        page.click("start");
        until("text('waiting').startsWith('A step is being computed')");
        page.openScene("01-falling-particle");
        runToTheEnd();
        assertEquals("", page.text("waiting"));
    }

    @Test
    void nothingIsSaidOfTheLimitOfASolverOfOnesOwnAndALongStepIsNamed() {
        page.openScene("02-one-spring");
        page.choose("solver", Browser.SOLVER);
        until("text('sentence').includes('your own')");
        assertEquals("", page.text("limit"));
        page.choose("solver", "rk4");
        until("text('limit').startsWith('Stable at least')");
        setStep("1e8");
        assertEquals("Longer than the scene: one step of 12.57 s.", page.text("limit"));
    }

    /** A thrown particle: its trail is a parabola through the steps, however few the pictures. */
    @Test
    void trailsGoThroughAllSteps() {
        page.openScene("01-falling-particle");
        runToTheEnd();
        assertEquals(List.of(), page.script("""
                const {view, energy} = window.lab, seen = view.trails.samples.map(({time}) => time);
                return energy.data[0].filter(time => !seen.some(one => Math.abs(one - time) < 1e-6));
                """));
    }

    @Test
    void ratesAreThoseOfThisSceneAndAxesHaveNoNumbersBeforeThereIsAnyMotion() {
        page.openScene("02-one-spring");
        runToTheEnd();
        until("text('pace') !== ''");
        page.openScene("01-falling-particle");
        assertEquals("", page.text("pace"));
        assertEquals(List.of(), page.script("""
                return window.lab.energy.plot.axes.slice(1).flatMap(axis => axis._values ?? []).filter(text => text);
                """));
        assertEquals(1.5, value("energy.plot.scales.x.max"));
    }
}
