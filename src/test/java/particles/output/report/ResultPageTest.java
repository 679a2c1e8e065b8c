package particles.output.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Texts.assertHas;
import static particles.Texts.assertStarts;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import particles.experiments.runs.SolverChoice;
import particles.output.charts.ChartFormat;
import particles.output.files.OutputFolder;
import particles.view.Axis;
import particles.view.Chart;
import particles.view.DataTable;
import particles.view.Look;
import particles.view.Panel;
import particles.view.Series;
import particles.view.Series.Mark;

class ResultPageTest {
    private static final Axis HEIGHT = Axis.linear("|height|", "m");
    private static final DataTable TABLE = new DataTable("cost", "What it costs", List.of(DataTable.column("solver"),
            DataTable.column("error (m)"), DataTable.column("evaluations")),
            List.of(List.of("rk4, \"old\"", 1.23456789e-7, 400L), List.of("a|b", Double.NaN, 12_345_678L)));

    @Test
    void tablesHaveAllDigitsInFilesAndFewForPeople() {
        assertEquals(List.of("solver,error (m),evaluations", "\"rk4, \"\"old\"\"\",1.23456789E-7,400",
                "a|b,NaN,12345678"),
                TableText.csv(TABLE));
        assertEquals(List.of("solver      error (m)  evaluations", "rk4, \"old\"   1.235e-7          400",
                "a|b                 \u2013     12345678"), TableText.plain(TABLE));
    }

    @Test
    void numbersArePlainWhereThatIsShort() {
        DataTable numbers = new DataTable("n", "n", List.of(new DataTable.Column("x", 3)),
                List.of(List.of(1234567.0), List.of(12.3456), List.of(0.0), List.of(-2.0), List.of(1e22),
                List.of(1.0 / 0)));
        assertEquals(List.of("x", "1230000", "12.3", "0", "-2", "1e22", "\u221e"),
                TableText.plain(numbers).stream().map(String::strip).toList());
    }

    @Test
    void longTablesAreFilesOnly(@TempDir Path path) throws IOException {
        List<List<Object>> rows = Collections.nCopies(101, List.of("many"));
        try (OutputFolder folder = OutputFolder.open(path)) {
            new ResultPage("long", "Long", List.of(), List.of(), List.of(new DataTable("all", "All",
                    List.of(DataTable.column("a")), rows))).write(folder, ChartFormat.PAGE);
        }
        String text = Files.readString(path.resolve("long.md"));
        assertTrue(text.contains("All 101 rows: [all.csv](all.csv).") && !text.contains("| many |"), text);
        assertEquals(102, Files.readAllLines(path.resolve("all.csv")).size());
    }

    @Test
    void rowsHaveACellForEachColumn() {
        assertThrows(IllegalArgumentException.class,
                () -> new DataTable("t", "t", List.of(DataTable.column("a")), List.of(List.of(1, 2))));
    }

    @Test
    void pageIsPicturesTheirNumbersTablesAndText(@TempDir Path path) throws IOException {
        Chart data = new Chart(Axis.TIME, HEIGHT, List.of(new Series(Look.OWN, "ball", Mark.LINE,
                new double[] {0, 0.5}, new double[] {1, -0.25}).ending(HEIGHT)));
        Panel falls = Panel.of("falls", List.of(data)).answered("-0.25 m");
        ResultPage page = new ResultPage("fall", "It falls", List.of("As all does."), List.of(
                Picture.of("height", "Height over time.", falls),
                Picture.panels("both", "Twice.", "Two",
                List.of(falls, Panel.phase("falls", data, Optional.empty())))), List.of(TABLE));
        try (OutputFolder folder = OutputFolder.open(path.resolve("fall"))) {
            page.write(folder, ChartFormat.PAGE);
        }
        Path made = path.resolve("fall");
        assertEquals(List.of("chart,series,x quantity,x,y quantity,y", "falls,ball,time (s),0.0,|height| (m),1.0",
                "falls,ball,time (s),0.5,|height| (m),-0.25"), Files.readAllLines(made.resolve("height.csv")));
        assertEquals(TableText.csv(TABLE), Files.readAllLines(made.resolve("cost.csv")));
        String text = Files.readString(made.resolve("fall.md"));
        assertStarts(text, "# It falls\n\nAs all does.\n\n![Height over time.](height.png)\n");
        assertHas(text, """
                falls: -0.25 m

                | \\|height\\| (m) | ball |
                | --- | ---: |
                | | -0.25 m |
                """, """
                | solver | error (m) | evaluations |
                | --- | ---: | ---: |
                | rk4, "old" | 1.235e-7 | 400 |
                | a\\|b | \u2013 | 12345678 |
                """);
        assertTrue(Files.size(made.resolve("height.png")) > 1000 && Files.size(made.resolve("both.png")) > 1000);
    }

    private static Series curve(String solver, double y) {
        return new Series(SolverChoice.of(solver).look(), solver, Mark.LINE, new double[] {0, 1}, new double[] {1, y});
    }

    private static List<List<String>> names(Picture picture) {
        return picture.panels().stream().map(panel -> panel.charts().stream().flatMap(chart -> chart.series().stream())
                .map(Series::name).toList()).toList();
    }

    /** Seven solvers are two groups here: a panel each, on the same axes, and every curve and its cross once. */
    @Test
    void tooManyCurvesForOnePanelAreShownByGroups() {
        List<Series> series = new ArrayList<>(Stream.of("euler", "midpoint", "rk4", "adams", "verlet", "yoshida4")
                .map(solver -> curve(solver, solver.length())).toList());
        Picture six = Picture.of("many", "", Panel.of("t", List.of(new Chart(Axis.TIME, HEIGHT, List.copyOf(series)))));
        assertEquals(List.of(six), six.laidOut(ChartFormat.PAGE));
        series.add(curve("symplectic-euler", 2));
        series.add(Series.point(SolverChoice.of("euler").look(), "stopped", Mark.FAILURES, 1, 2));
        Chart chart = new Chart(Axis.TIME, HEIGHT, series);
        Chart never = new Chart(Axis.TIME, Axis.linear("never", ""), List.of(
                Series.point(SolverChoice.of("euler").look(), "unstable", Mark.FAILURES, 1, 0),
                Series.point(SolverChoice.of("verlet").look(), "unstable", Mark.FAILURES, 1, 1)))
                .inRows(List.of("euler", "verlet"));
        List<Picture> pages = Picture.of("many", "", Panel.of("t", List.of(chart, never, chart.named("again"))))
                .laidOut(ChartFormat.PAGE);
        assertEquals(List.of("many", "many-again"), pages.stream().map(Picture::name).toList());
        assertEquals(List.of(List.of("euler", "midpoint", "rk4", "adams", "stopped", "unstable"),
                List.of("verlet", "yoshida4", "symplectic-euler", "unstable")), names(pages.get(0)));
        assertEquals(List.of("explicit, fixed step", "symplectic"), pages.get(0).panels().stream().map(Panel::title)
                .toList());
        Chart rows = pages.get(0).panels().get(1).charts().get(1);
        assertEquals(List.of("verlet"), rows.rows());
        assertEquals(0, rows.series().get(0).y()[0], "the row is the first one now");
        assertEquals(series, pages.get(0).panels().get(0).charts().get(0).scale(), "on the axes of all");
    }

    /** The solvers asked for come first; a solver of one's own is one of the five. */
    @Test
    void slidesHaveFiveCurvesAtMostAndOneChartEach() {
        List<Series> series = new ArrayList<>(Stream.of("euler", "midpoint", "rk4", "adams", "verlet", "radau")
                .map(solver -> curve(solver, 1)).toList());
        series.add(new Series(Look.OWN, "Mine", Mark.LINE, new double[] {0}, new double[] {1}));
        Chart chart = new Chart(Axis.TIME, HEIGHT, series);
        List<Picture> slides = Picture.of("many", "", Panel.of("t", List.of(chart, chart.named("again"))))
                .first(List.of("radau", "rk4")).laidOut(new ChartFormat(true, false, false));
        assertEquals(List.of("many", "many-again"), slides.stream().map(Picture::name).toList());
        assertEquals(List.of(List.of("euler", "midpoint", "rk4", "radau", "Mine")), names(slides.get(0)));
    }
}
