package browser;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Texts.assertHas;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import particles.app.Main;
import particles.app.cli.OptionStyle;
import particles.app.cli.Program;
import particles.app.run.StopRequest;

/** A recorded run is shown by the same page, without the compiled classes. */
class ReplayTest extends LabPageTestCase {
    private static final Path OUT = Path.of("build", "tmp", "browserTests", "replay");

    /** Runs a scene, opens its replay, and returns the console's lines. */
    private String replay(String... options) {
        StringWriter lines = new StringWriter();
        String[] all = Stream.concat(Stream.of("run", "--replay=true", "--frames=false", "--out=" + OUT),
                Arrays.stream(options)).toArray(String[]::new);
        new Program(Main.commands(new StopRequest()), OptionStyle.GRADLE, new PrintWriter(lines),
                new PrintWriter(lines)).execute(all);
        page.go(OUT.resolve("replay.html").toUri().toString());
        return lines.toString();
    }

    private void look(double time) {
        page.script("const time = document.getElementById('time'); time.value = arguments[0];"
                + " time.dispatchEvent(new Event('input'));", time);
        until("Math.abs(number('clock') - " + time + ") < 0.02");
    }

    /** Checks that the particles seen are those of the trajectory at the same time, in single precision. */
    private void assertSeenAsInTheTrajectory() throws IOException {
        double time = value("view.moment.time");
        List<String> rows = Files.readAllLines(OUT.resolve("trajectory.csv")).stream()
                .filter(row -> row.startsWith(time + ",")).map(row -> row.substring(row.indexOf(',') + 1)).toList();
        List<?> counts = (List<?>) page.script("""
                const {ids} = window.lab.view.structure, {state} = window.lab.view.moment;
                const rows = new Map(arguments[0].map(row => {
                  const [, id, numbers] = /^"?(.*?)"?,((?:[^,]*,){5}[^,]*)$/.exec(row);
                  return [id, numbers.split(',').map(Math.fround).join()];
                }));
                return [ids.filter((id, i) => rows.get(id) === state.subarray(6 * i, 6 * i + 6).join()).length,
                  Math.max(ids.length, rows.size)];
                """, rows);
        assertEquals(counts.get(1), counts.get(0), "at " + time + " s");
    }

    /**
     * A spring, a fountain whose particles come and go, and a cloth. Steps of the fountain end every 0.01 s and at
     * births, every 1/150 s: at 40 + 60 times, 20 of which are both.
     */
    @ParameterizedTest
    @CsvSource({"2, 0.05, 8", "27, 0.01, 80", "9, 0.002, 200"})
    void statesAndCurvesAreThoseOfTheRun(String scene, double deltaT, int steps) throws IOException {
        replay("--scene=" + scene, "--duration=0.4", "--deltaT=" + deltaT);
        assertEquals(steps + 1L, value("energy.data[0].length"));
        assertHas(page.text("note"), "deltaT = " + deltaT + " s.");
        for (double time : new double[] {0.4, 0.2 + 1e-9, 0}) {
            look(time);
            assertSeenAsInTheTrajectory();
        }
        assertFalse(page.element("solver").isDisplayed());
        assertFalse(page.element("addPanel").isDisplayed());
        page.click("start");
        until("number('clock') === 0.4 && text('start') === 'Start'");
        page.screenshot("replay-" + scene);
    }

    @Test
    void aRunThatFailedEndsWithItsWords() {
        String lines = replay("--scene=12", "--solver=rk4", "--deltaT=0.01");
        assertTrue(lines.contains("files in " + OUT) && lines.contains("replay.html"), lines);
        page.click("start");
        until("text('message').includes('stopped at t = ')");
        assertEquals("Start", page.text("start"));
    }

    @Test
    void aLongRunIsThinnedToTenMegabytesAndBothPageAndConsoleSaySo() throws IOException {
        String lines = replay("--scene=9", "--duration=3", "--deltaT=0.002");     // 1501 states of 695 particles
        long size = Files.size(OUT.resolve("replay.html"));
        assertTrue(size > 5_000_000 && size <= 10_000_000, size + " bytes");
        String thinned = "states closer than 0.008 s are left out, to stay below 10 MB";
        assertHas(lines, "replay.html: " + thinned);
        assertHas(page.text("note"), thinned);
        assertEquals(376, value("energy.data[0].length"));
        look(3);
        assertSeenAsInTheTrajectory();
    }
}
