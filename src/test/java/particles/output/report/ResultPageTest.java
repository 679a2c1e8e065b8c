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
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import particles.output.charts.ChartFormat;
import particles.output.charts.Panel;
import particles.output.files.OutputFolder;
import particles.view.ChartData;
import particles.view.ChartData.Mark;
import particles.view.ChartData.Series;
import particles.view.DataTable;

class ResultPageTest {
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
        ChartData data = new ChartData("falls", "time (s)", "height (m)", false, false,
                List.of(new Series("ball", Mark.LINE, new double[] {0, 0.5}, new double[] {1, -0.25})));
        ResultPage page = new ResultPage("fall", "It falls", List.of("As all does."), List.of(
                Picture.of("height", "Height over time.", Panel.chart(data)),
                Picture.panels("both", "Twice.", "Two",
                List.of(Panel.chart(data), Panel.phase(data, Optional.empty())))), List.of(TABLE));
        try (OutputFolder folder = OutputFolder.open(path.resolve("fall"))) {
            page.write(folder, ChartFormat.PAGE);
        }
        Path made = path.resolve("fall");
        assertEquals(List.of("chart,series,x quantity,x,y quantity,y", "falls,ball,time (s),0.0,height (m),1.0",
                "falls,ball,time (s),0.5,height (m),-0.25"), Files.readAllLines(made.resolve("height.csv")));
        assertEquals(TableText.csv(TABLE), Files.readAllLines(made.resolve("cost.csv")));
        String text = Files.readString(made.resolve("fall.md"));
        assertStarts(text, "# It falls\n\nAs all does.\n\n![Height over time.](height.png)\n");
        assertHas(text, """
                | solver | error (m) | evaluations |
                | --- | ---: | ---: |
                | rk4, "old" | 1.235e-7 | 400 |
                | a\\|b | \u2013 | 12345678 |
                """);
        assertTrue(Files.size(made.resolve("height.png")) > 1000 && Files.size(made.resolve("both.png")) > 1000);
    }

    /** Seven solvers are two families here: a panel each, and every curve once. */
    @Test
    void tooManyCurvesForOnePanelAreShownByFamilies() {
        List<Series> series = new ArrayList<>();
        for (String solver : List.of("euler", "midpoint", "rk4", "adams", "verlet", "yoshida4")) {
            series.add(new Series(solver, Mark.LINE, new double[] {0, 1}, new double[] {1, series.size()}));
        }
        Picture six = picture(List.copyOf(series));
        assertEquals(List.of(six), six.laidOut(ChartFormat.PAGE));
        series.add(new Series("symplectic-euler", Mark.LINE, new double[] {0, 1}, new double[] {2, 2}));
        series.add(new Series("stopped", Mark.FAILURES, new double[] {1}, new double[] {2}));
        List<Picture> pages = picture(series).laidOut(ChartFormat.PAGE);
        assertEquals(1, pages.size());
        assertEquals(List.of(List.of("euler", "midpoint", "rk4", "adams", "stopped"),
                List.of("verlet", "yoshida4", "symplectic-euler", "stopped")),
                pages.get(0).data().stream().map(data -> data.series().stream().map(Series::name).toList()).toList());
        List<Picture> slides = six.laidOut(new ChartFormat(true, false, false));
        assertEquals(List.of("many-explicit", "many-symplectic"), slides.stream().map(Picture::name).toList());
        assertEquals(List.of("t (explicit, fixed step)", "t (symplectic)"),
                slides.stream().map(slide -> slide.data().get(0).title()).toList());
        series.set(7, Series.point("mine.HeunSolver", Mark.LINE, 1, 1));
        assertEquals("t (symplectic and your own)", picture(series).laidOut(new ChartFormat(true, false, false)).get(1)
                .data().get(0).title());
    }

    /** The size of a quantity is another one: |y| in the first picture, y in the second. */
    @Test
    void eachPictureOfFamiliesHasOneQuantity() {
        List<Series> series = Stream.of("euler", "midpoint", "rk4", "adams", "verlet", "yoshida4", "radau")
                .map(solver -> Series.point(solver, Mark.LINE, 1, 1)).toList();
        Picture two = Picture.bySolver("many", "", series, Series::name, some -> Stream.of("|y|", "y").map(quantity ->
                new ChartData("t", "x", quantity, false, false, some)).toList());
        assertEquals(List.of(Set.of("|y|"), Set.of("y")), two.laidOut(ChartFormat.PAGE).stream().map(page ->
                page.data().stream().map(ChartData::yLabel).collect(Collectors.toSet())).toList());
    }

    private static Picture picture(List<Series> series) {
        return Picture.bySolver("many", "", series, Series::name, some -> List.of(new ChartData("t", "x", "y", false,
                false, some)));
    }
}
