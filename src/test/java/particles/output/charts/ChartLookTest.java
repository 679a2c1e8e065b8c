package particles.output.charts;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Texts.assertHas;

import deSolvers.catalog.SolverCatalog;
import java.awt.Color;
import java.awt.geom.Area;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import javax.xml.parsers.DocumentBuilderFactory;
import org.jfree.chart.ChartRenderingInfo;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.plot.XYPlot;
import org.jfree.data.Range;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.w3c.dom.Document;
import particles.output.files.OutputFolder;
import particles.output.report.Picture;
import particles.view.Axis;
import particles.view.Chart;
import particles.view.Look;
import particles.view.Panel;
import particles.view.Series;
import particles.view.Series.Mark;

/** How charts fit themselves to a page. */
class ChartLookTest {
    private static final int WIDE = 16;
    private static final int HIGH = 9;
    private static final Look RK4 = Look.of(SolverCatalog.info("rk4"));

    private static Chart ellipse(double omega) {
        double[] x = IntStream.range(0, 100).mapToDouble(k -> StrictMath.cos(k * 0.1)).toArray();
        double[] v = IntStream.range(0, 100).mapToDouble(k -> -omega * StrictMath.sin(k * 0.1)).toArray();
        return new Chart(Axis.linear("position x", "m"), Axis.linear("velocity v", "m/s"),
                List.of(new Series(RK4, "rk4", Mark.LINE, x, v)));
    }

    /** @return pixels a unit along x over pixels a unit along y */
    private static double aspect(Panel panel, int width, int height) {
        JFreeChart chart = Charts.of(panel, false, ChartFormat.PAGE);
        ChartRenderingInfo info = new ChartRenderingInfo();
        chart.draw(new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB).createGraphics(),
                new Rectangle2D.Double(0, 0, width, height), info);
        Rectangle2D area = info.getPlotInfo().getDataArea();
        XYPlot plot = chart.getXYPlot();
        return area.getWidth() / plot.getDomainAxis().getRange().getLength()
                / (area.getHeight() / plot.getRangeAxis().getRange().getLength());
    }

    /** Measured: within 0.42 % and, on a map as narrow as 36 pixels, 3 %, since frames end at whole pixels. */
    @ParameterizedTest
    @CsvSource(textBlock = """
            720, 700, t
            640, 360, t
            360, 370, t
            300, 800, t
            640, 360, "midpoint, deltaT = 0.1 s, 5000 steps, on a chain of many springs that swings in wind"
            """, quoteCharacter = '"')
    void circlesAreRoundOnPagesOfAnyShape(int width, int height, String title) {
        assertEquals(1, aspect(Panel.phase(title, ellipse(1), Optional.empty()), width, height), 0.01);
        assertEquals(1, aspect(Panel.map(title, ellipse(5)), width, height), 0.035);
    }

    /** An orbit at omega = 5 or 380 fills its picture. */
    @ParameterizedTest
    @ValueSource(doubles = {5, 380})
    void otherOrbitsFillTheirPicture(double omega) {
        assertTrue(aspect(Panel.phase("t", ellipse(omega), Optional.empty()), 900, 560) > 2.5, "stretched");
    }

    @Test
    void rangesThatDifferByAThirdAreAlike() {
        assertTrue(ChartPlot.areAlike(new Range(0, 4), new Range(0, 3)));
        assertTrue(!ChartPlot.areAlike(new Range(0, 4), new Range(0, 2.9)));
    }

    @Test
    void labelsStandNearTheirLinesAndApart() {
        assertArrayEquals(new double[] {1, 30}, EndLabels.spread(new double[] {1, 30}, 10, -100, 100));
        assertArrayEquals(new double[] {0, 10, 20}, EndLabels.spread(new double[] {10, 10, 10}, 10, -100, 100), 0.01);
        assertArrayEquals(new double[] {90, 100}, EndLabels.spread(new double[] {99, 99}, 10, 0, 100), 1,
                "to a pixel");
        Random random = new Random(7);
        for (int trial = 0; trial < 50; trial++) {
            double[] wanted = random.doubles(14, 0, 60).sorted().toArray();
            double[] places = EndLabels.spread(wanted, 10, -1000, 1000);
            for (int k = 1; k < places.length; k++) {
                assertTrue(places[k] - places[k - 1] >= 10 - 0.01, "apart");
            }
            assertEquals(Arrays.stream(wanted).sum(), Arrays.stream(places).sum(), 1e-6, "about the same middle");
        }
    }

    @Test
    void endsOfPathAndReferenceHaveOneMark() {
        Chart ends = new Chart(Axis.TIME, Axis.TIME, List.of(
                Series.point(Look.MARK, "reference end", Mark.OPEN_POINTS, 1, 1),
                Series.point(Look.MARK, "end", Mark.POINTS, 0, 1)));
        XYPlot plot = Charts.of(Panel.phase("t", ends, Optional.empty()), false, ChartFormat.PAGE).getXYPlot();
        assertTrue(new Area(plot.getRenderer().getSeriesShape(0)).equals(
                new Area(plot.getRenderer().getSeriesShape(1))));
    }

    /** Three runs of one solver, two solvers of one's own, two kinds of work, and others. */
    @Test
    void noTwoLinesOfAChartLookTheSame() {
        List<Series> series = new ArrayList<>();
        for (Look look : List.of(RK4, RK4, RK4, Look.OWN, Look.OWN, Look.WORK, Look.WORK, Look.DRIVEN, Look.ERROR,
                Look.number(0))) {
            series.add(new Series(look, "line " + series.size(), Mark.LINE, new double[] {0, 1},
                    new double[] {series.size(), 1}));
        }
        XYPlot plot = Charts.of(Panel.of("t", List.of(new Chart(Axis.TIME, Axis.TIME, series))), false,
                ChartFormat.PAGE).getXYPlot();
        Set<List<Object>> looks = new HashSet<>();
        for (int k = 0; k < series.size(); k++) {
            assertTrue(looks.add(List.of(plot.getRenderer().getSeriesPaint(k), plot.getRenderer().getSeriesStroke(k))),
                    "line " + k);
        }
    }

    @Test
    void slidesAreWideAndSvgHasTheTextOfTheChart(@TempDir Path top) throws Exception {
        Chart below = new Chart(Axis.TIME, Axis.linear("energy error", ""), List.of(new Series(Look.ERROR, "b",
                Mark.LINE, new double[] {0, 1}, new double[] {0, 1}))).named("energy-error");
        ChartFormat format = new ChartFormat(true, true, false);
        try (ChartWriter writer = new ChartWriter(OutputFolder.open(top), format)) {
            for (Picture slide : Picture.of("energy", "", Panel.of("t", List.of(ellipse(3), below))).laidOut(format)) {
                writer.write(slide.file(), slide.page(format).orElseThrow());
            }
        }
        for (String name : List.of("energy.png", "energy-energy-error.png")) {
            BufferedImage slide = ImageIO.read(top.resolve(name).toFile());
            assertEquals(slide.getWidth() * HIGH, slide.getHeight() * WIDE, name);
        }
        Document svg = DocumentBuilderFactory.newInstance().newDocumentBuilder()
                .parse(top.resolve("energy.svg").toFile());
        assertEquals("svg", svg.getDocumentElement().getTagName());
        String text = IntStream.range(0, svg.getElementsByTagName("text").getLength())
                .mapToObj(k -> svg.getElementsByTagName("text").item(k).getTextContent()).toList().toString();
        assertHas(text, "position x (m)", "rk4");
        assertTrue(svg.getElementsByTagName("path").getLength() > 0, "and its lines");
    }

    /** Lightness is inverted and hue kept: black text becomes white, and blue a light blue, in both kinds of file. */
    @Test
    void darkChartsAreTheSameOnBlack(@TempDir Path top) throws Exception {
        ChartFormat format = new ChartFormat(true, true, true);
        new ChartWriter(OutputFolder.open(top), format).write("energy.png",
                ChartPage.of(Panel.of("t", List.of(ellipse(3))), format));
        assertEquals(0xff000000, ImageIO.read(top.resolve("energy.png").toFile()).getRGB(3, 3));
        String svg = Files.readString(top.resolve("energy.svg"));
        assertFalse(svg.contains("fill:white"), svg);
        assertTrue(svg.contains("rgb(221,221,221)"), "text, 0x222222 on white");
        assertEquals(new Color(0x4dbfff), format.on(new Color(0x0072b2)));
        assertEquals(new Color(0x222222), format.on(new Color(0xdddddd)), "the grid stays faint");
    }

    /** Contrast as the Web Content Accessibility Guidelines define it, at least 3 to 1 for lines; 2.7 was too dim. */
    @Test
    void everyLineIsSeenOnBlack() {
        for (String solver : SolverCatalog.names()) {
            requireContrast(new Color(Look.of(SolverCatalog.info(solver)).rgb()));
        }
        IntStream.range(0, 7).mapToObj(k -> new Color(Look.number(k).rgb())).forEach(ChartLookTest::requireContrast);
    }

    private static void requireContrast(Color onWhite) {
        Color colour = new ChartFormat(false, false, true).on(onWhite);
        double luminance = 0.2126 * linear(colour.getRed()) + 0.7152 * linear(colour.getGreen())
                + 0.0722 * linear(colour.getBlue());
        assertTrue((luminance + 0.05) / 0.05 >= 3, onWhite + " becomes " + colour);
    }

    private static double linear(int part) {
        double value = part / 255.0;
        return value <= 0.03928 ? value / 12.92 : Math.pow((value + 0.055) / 1.055, 2.4);
    }

    @Test
    void gridsHaveFullRowsWhereThatIsPossible() {
        assertEquals(List.of(1, 2, 3, 4, 3, 3, 3, 4, 3), IntStream.rangeClosed(1, 9).mapToObj(PanelGrid::columns)
                .toList());
    }
}
