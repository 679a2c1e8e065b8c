package particles.app.experiments;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Texts.assertHas;
import static particles.Texts.assertStarts;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import particles.SimulationException;
import particles.app.cli.ExitCode;
import particles.app.cli.OptionStyle;
import particles.app.cli.Screen;
import particles.output.files.OutputException;
import particles.view.DataTable;

class ReportCommandTest {
    private static final RuntimeException ODD = new IllegalStateException("odd");

    @TempDir
    Path top;

    /** Shows which scene and how many solvers it was given. */
    private static final Experiment SHOWS = new Experiment("shows", "Shows.", "So it is.", Set.of("--scene"),
            "one-spring", "radau", asked -> (folder, progress) -> {
                progress.reached(0.5, "half");
                return asked.page(asked.scene().title() + " by " + asked.solvers().size(), List.of(), List.of(
                        new DataTable("t", "Numbers", List.of(DataTable.column("x")), List.of(List.of(0.125)))));
            });

    private Screen report(ExitCode expected, RuntimeException why, String... options) {
        Experiment fails = new Experiment("fails", "Fails.", "", Set.of(), "", "all", asked -> (folder, progress) -> {
            throw why;
        });
        Screen screen = Screen.of(List.of(new ReportCommand(List.of(fails, SHOWS))), OptionStyle.GRADLE,
                Stream.concat(Stream.of("report", "--out=" + top.resolve("report")), Stream.of(options))
                        .toArray(String[]::new));
        assertEquals(expected, screen.code(), screen.err());
        return screen;
    }

    private String page() throws IOException {
        return Files.readString(top.resolve("report/report.html"));
    }

    @Test
    void experimentThatFailsIsWrittenAndTheOthersStand() throws IOException {
        Screen screen = report(ExitCode.DONE, new SimulationException(1.5, -1, "no <reference>", null));
        String page = page();
        assertHas(page, "could not be made", "no &lt;reference&gt;", "<h2>One spring by 1</h2>",
                "data-value=\"0.125\"");
        assertHas(screen.out(), "failed: ", "One spring by 1");
        assertTrue(Files.exists(top.resolve("report/shows/shows.md")), "each has its folder too");
        assertEquals("", screen.err());
    }

    @Test
    void mistakesOfTheProgramAreWrittenToo() throws IOException {
        report(ExitCode.DONE, ODD);
        assertHas(page(), "internal error", "odd");
    }

    /** Its limits are measured on springs, as they are in a scene. */
    @Test
    void aClassOfYourOwnHasItsLimits() throws IOException {
        Screen screen = Screen.of(List.of(new ReportCommand()), OptionStyle.GRADLE, "report",
                "--out=" + top.resolve("report"), "--experiments=stability",
                "--solvers=rk4,particles.experiments.stability.StabilityLimitsTest$Heun");
        assertEquals(ExitCode.DONE, screen.code(), screen.err());
        assertHas(page(), "StabilityLimitsTest$Heun", "always grows: 1.25e-5 per step");
        assertFalse(page().contains("could not be made"));
    }

    @Test
    void fullDiskEndsAll() {
        OutputException full = new OutputException(top, "write", new IOException("no space left"));
        report(ExitCode.TROUBLE, full);
        assertFalse(Files.exists(top.resolve("report/report.html")));
    }

    @Test
    void sceneWithAnOddNameIsLookedAtByThoseWhoLookAtScenes() throws IOException {
        Path odd = top.resolve("a & 'b' <i>.yaml");
        Files.writeString(odd, Files.readString(Path.of("scenes/02-one-spring.yaml"))
                .replaceFirst("title: .*", "title: \"<script>alert('&')</script>\""));
        report(ExitCode.DONE, ODD, "--scene=" + odd, "--experiments=shows");
        String page = page();
        assertFalse(page.contains("<script>alert") || page.contains("<i>"), page);
        assertHas(page, "<h2>&lt;script&gt;alert('&amp;')&lt;/script&gt; by 5</h2>");
        assertFalse(page.contains("could not be made"), "only what was asked for");
        report(ExitCode.DONE, ODD, "--scene=" + odd);
        assertFalse(page().contains("could not be made"), "and by default only what looks at the scene");
    }

    @Test
    void whatIsNotThereIsSaidBeforeAnythingRuns() {
        assertStarts(report(ExitCode.BAD_INPUT, ODD, "--experiments=shws").err(),
                "option -Pexperiments: no experiment is called 'shws'; did you mean 'shows'?");
        report(ExitCode.BAD_INPUT, ODD, "--scene=sprng");
        report(ExitCode.BAD_INPUT, ODD, "--solvers=rk5");
        report(ExitCode.BAD_INPUT, ODD, "--scene=2", "--set=duration=-1");
        assertHas(report(ExitCode.BAD_INPUT, ODD, "--set=duration=1").err(), "-Pset: goes with -Pscene only");
        assertFalse(Files.exists(top.resolve("report")), "nothing is written");
    }
}
