package particles.app.experiments;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Texts.assertHas;
import static particles.Texts.assertStarts;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import particles.SimulationException;
import particles.app.cli.ExitCode;
import particles.app.cli.OptionStyle;
import particles.app.cli.PrintedProgress;
import particles.app.cli.ProgramCommand.Mistakes;
import particles.app.cli.Screen;
import particles.experiments.runs.ProgressListener;
import particles.output.files.OutputException;
import particles.output.files.OutputFolder;
import particles.output.report.ResultPage;
import particles.view.DataTable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

class ReportCommandTest {
    private static final RuntimeException ODD = new IllegalStateException("odd");

    @TempDir
    Path top;

    /** Shows which scene it was given. */
    @Command(name = "shows", description = "Shows.")
    private static final class Shows extends ExperimentCommand {
        @Mixin
        private final SceneOptions options = new SceneOptions();

        @Override
        protected void read(Mistakes mistakes) {
            options.read(mistakes, this, "one-spring", "radau");
            super.read(mistakes);
        }

        @Override
        protected ResultPage measure(OutputFolder folder, ProgressListener progress) {
            progress.reached(0.5, "half");
            return new ResultPage("shows", options.scene().title() + " by "
                    + options.solvers().size(), List.of("So it is."), List.of(),
                    List.of(new DataTable("t", "Numbers", List.of(DataTable.column("x")), List.of(List.of(0.125)))));
        }
    }

    @Command(name = "fails", description = "Fails.")
    private static final class Fails extends ExperimentCommand {
        private final RuntimeException why;

        Fails(RuntimeException why) {
            this.why = why;
        }

        @Override
        protected ResultPage measure(OutputFolder folder, ProgressListener progress) {
            throw why;
        }
    }

    /**
     * The countdown is right within a factor of 1.5 wherever it is printed, to the 5 s to which it is rounded. Measured
     * times of a report of the course (s): on two quiet cores, CPU times on busy ones, and on slower quiet ones, where
     * the page of all took 9 s.
     */
    @Test
    void theCountdownIsNearlyRight() {
        List<ExperimentCommand> all = List.of(new LectureFiguresCommand(), new EnergyDriftCommand(),
                new PhasePlotsCommand(), new RaceCommand(), new WorkPrecisionCommand(), new StiffGalleryCommand(),
                new StabilityCommand(), new EffectCostCommand(), new StiffClothCommand());
        for (double[] seconds : new double[][] {{2, 2, 0.4, 3, 42, 5, 2, 4, 25},
            {3.5, 4.1, 0.3, 11.8, 62.3, 6.8, 2.8, 5.9, 21.5}, {3, 4, 0.3, 7, 56, 7, 2, 5, 23}}) {
            StringWriter text = new StringWriter();
            double[] elapsed = {0};
            double whole = Arrays.stream(seconds).sum() + 9;
            new PrintedProgress(new PrintWriter(text), () -> (long) (1e9 * elapsed[0])).part(0, 1 - ReportCommand.PAGE)
                    .parts(all, ReportCommand::seconds, (task, part) -> {
                        for (int tenth = 1; tenth <= 10; tenth++) {
                            elapsed[0] += seconds[all.indexOf(task)] / 10;
                            part.reached(tenth / 10.0, "left: " + (whole - elapsed[0]));
                        }
                        return task;
                    });
            List<MatchResult> said = Pattern.compile("about (\\d+) s left: left: (.*)").matcher(text.toString())
                    .results().toList();
            assertFalse(said.isEmpty());
            for (MatchResult one : said) {
                double about = Double.parseDouble(one.group(1));
                double left = Double.parseDouble(one.group(2));
                assertTrue(about < 1.5 * left + 2.5 && left < 1.5 * (about + 2.5), one.group());
            }
        }
    }

    private Screen report(ExitCode expected, RuntimeException why, String... options) {
        Screen screen = Screen.of(List.of(new ReportCommand(List.of(new Fails(why), new Shows()))), OptionStyle.GRADLE,
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

    /** A reference run of all 4 s takes 84 s, and experiments differ by ten times: no time is told. */
    @Test
    @Tag("slow")
    void aSceneThatTakesLongIsShortened() throws IOException {
        Screen screen = report(ExitCode.DONE, ODD, "--scene=17");
        assertHas(screen.out(), "the report is over the first 0.", "-Pduration=4 is over all of it");
        assertFalse(screen.out().contains(" s left"));
        assertHas(page(), ", for 0.");
        assertFalse(report(ExitCode.DONE, ODD, "--scene=17", "--duration=3").out().contains("the report is over"));
        assertHas(page(), ", for 3 s");
    }

    @Test
    void whatIsNotThereIsSaidBeforeAnythingRuns() {
        assertStarts(report(ExitCode.BAD_INPUT, ODD, "--experiments=shws").err(),
                "option -Pexperiments: no experiment is called 'shws'; did you mean 'shows'?");
        report(ExitCode.BAD_INPUT, ODD, "--scene=sprng");
        report(ExitCode.BAD_INPUT, ODD, "--solvers=rk5");
        report(ExitCode.BAD_INPUT, ODD, "--scene=2", "--duration=-1");
        assertHas(report(ExitCode.BAD_INPUT, ODD, "--duration=1").err(), "-Pduration: goes with -Pscene only");
        assertFalse(Files.exists(top.resolve("report")), "nothing is written");
    }
}
