package particles.output.charts;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.catalog.SolverCatalog;
import java.awt.Color;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.LegendItemCollection;
import org.jfree.chart.axis.AxisState;
import org.jfree.chart.axis.LogAxis;
import org.jfree.chart.axis.SymbolAxis;
import org.jfree.chart.axis.ValueAxis;
import org.jfree.chart.axis.ValueTick;
import org.jfree.chart.plot.CombinedDomainXYPlot;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.ui.RectangleEdge;
import org.jfree.data.Range;
import org.jfree.data.xy.XYDataset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import particles.experiments.lecture.LectureFigures;
import particles.output.files.OutputFolder;
import particles.view.Axis;
import particles.view.Chart;
import particles.view.Look;
import particles.view.Panel;
import particles.view.Series;
import particles.view.Series.Mark;
import particles.view.VectorField;

/** Charts by what they were given to draw; how they look is for eyes. */
class ChartsTest {
    @TempDir
    Path top;

    private static Chart chart(boolean log, Series... series) {
        return new Chart(new Axis("x", "m", log), new Axis("y", "s", log), List.of(series));
    }

    private static JFreeChart drawn(Chart... charts) {
        return Charts.of(Panel.of("title", List.of(charts)), false, ChartFormat.PAGE);
    }

    private static XYPlot path(Chart chart, Optional<VectorField> field) {
        return Charts.of(Panel.phase("title", chart, field), false, ChartFormat.PAGE).getXYPlot();
    }

    private static Look look(String solver) {
        return Look.of(SolverCatalog.info(solver));
    }

    private static Series series(String name, double... y) {
        return series(Look.OWN, name, y);
    }

    private static Series series(Look look, String name, double... y) {
        return new Series(look, name, Mark.LINE_AND_POINTS,
                IntStream.rangeClosed(1, y.length).asDoubleStream().toArray(), y);
    }

    private static XYPlot plot(boolean log, Series... series) {
        return drawn(chart(log, series)).getXYPlot();
    }

    @Test
    void theDatasetIsTheData() {
        JFreeChart chart = drawn(chart(false, series("same", 1, 4, 9), series("same", -1, -2)));
        XYDataset dataset = chart.getXYPlot().getDataset();
        assertEquals(2, dataset.getSeriesCount());
        assertEquals(3, dataset.getItemCount(0));
        assertEquals(9, dataset.getYValue(0, 2));
        assertEquals(3, dataset.getXValue(0, 2));
        assertEquals(-2, dataset.getYValue(1, 1));
        assertEquals("title", chart.getTitle().getText());
        assertEquals("x (m)", chart.getXYPlot().getDomainAxis().getLabel());
        assertEquals("y (s)", chart.getXYPlot().getRangeAxis().getLabel());
        assertThrows(IllegalArgumentException.class, () -> new Series(Look.OWN, "short", Mark.LINE, new double[3],
                new double[2]));
    }

    @Test
    void whatHasNoPlaceOnAnAxisIsAGap() {
        Series odd = series("odd", 1, 0, -3, Double.NaN, Double.POSITIVE_INFINITY, 100);
        XYPlot log = plot(true, odd);
        assertInstanceOf(LogAxis.class, log.getRangeAxis());
        for (int k = 0; k < 6; k++) {
            assertEquals(k == 0 || k == 5, Double.isFinite(log.getDataset().getYValue(0, k)), "point " + k);
        }
        XYPlot linear = plot(false, odd);
        for (int k = 0; k < 6; k++) {
            assertEquals(k != 3 && k != 4, Double.isFinite(linear.getDataset().getYValue(0, k)), "point " + k);
        }
        assertEquals(100, linear.getRangeAxis().getUpperBound(), 6);
    }

    @Test
    void seriesDifferInMoreThanColour() {
        Set<List<Object>> looks = new HashSet<>();
        for (int k = 0; k < 42; k++) {
            assertTrue(looks.add(List.of(Look.number(k).rgb(), ChartStyle.stroke(k))), "series " + k);
        }
        for (int k = 1; k < 6; k++) {
            assertNotEquals(ChartStyle.stroke(k), ChartStyle.stroke(k - 1));
            assertNotEquals(ChartStyle.shape(k), ChartStyle.shape(k - 1));
        }
    }

    @Test
    void stackedChartsShareTheirTime() {
        JFreeChart chart = drawn(chart(false, series("a", 1, 2), series(Look.WORK, "b", 1, 2)),
                chart(false, series("drift", 0, 1e-14)));
        CombinedDomainXYPlot plot = assertInstanceOf(CombinedDomainXYPlot.class, chart.getPlot());
        assertEquals(2, plot.getSubplots().size());
        XYPlot below = plot.getSubplots().get(1);
        assertTrue(below.getRangeAxis().getUpperBound() < 1.2e-14, "a small drift fills its axis");
        assertEquals(List.of(2, 1), Charts.plots(chart).stream().map(part -> part.ends.labelled.size()).toList());
        assertTrue(Charts.isEmpty(Charts.legend(Charts.plots(chart), ChartFormat.PAGE)),
                "all names stand in the chart");
    }

    /** Runs without a result stand in rows below, named, from above in the order given; the legend has their mark. */
    @Test
    void rowsAreNamedAndFailuresAreInTheLegend() {
        Series line = new Series(look("rk4"), "rk4", Mark.LINE_AND_POINTS, new double[] {1, 10}, new double[] {1, 2});
        Chart below = new Chart(Axis.log("x", "m"), Axis.linear("no result", ""), List.of(Series.point(look("rk4"),
                "did not converge", Mark.FAILURES, 1000, 1))).inRows(List.of("euler", "rk4"));
        JFreeChart chart = drawn(chart(true, line), below);
        CombinedDomainXYPlot plot = assertInstanceOf(CombinedDomainXYPlot.class, chart.getPlot());
        SymbolAxis rows = assertInstanceOf(SymbolAxis.class, plot.getSubplots().get(1).getRangeAxis());
        assertEquals(List.of("euler", "rk4"), List.of(rows.getSymbols()));
        assertTrue(rows.isInverted());
        assertTrue(plot.getDomainAxis().getUpperBound() >= 1000, "the axis reaches to the failures");
        LegendItemCollection legend = Charts.legend(Charts.plots(chart),
                ChartFormat.PAGE).getSources()[0].getLegendItems();
        assertEquals(1, legend.getItemCount(), "rk4 has its name at its end");
        assertEquals("did not converge", legend.get(0).getLabel());
        assertEquals(ChartStyle.FAILURE, legend.get(0).getShape());
    }

    /** A solver that is never stable has no line, and a value of 0 has no place on a logarithmic axis. */
    @Test
    void aSeriesWithoutADrawnPointIsNotInTheLegend() {
        List<Series> series = DoubleStream.of(1, 0, Double.NaN).mapToObj(y -> Series.point(look("rk4"), "y = " + y,
                Mark.POINTS, 1, y)).toList();
        LegendItemCollection legend = Charts.legend(Charts.plots(drawn(new Chart(Axis.log("x", ""), Axis.log("y", ""),
                series))), ChartFormat.PAGE).getSources()[0].getLegendItems();
        assertEquals(1, legend.getItemCount());
        assertEquals("y = 1.0", legend.get(0).getLabel());
    }

    @Test
    void theLegendBeginsWithTheCurvesOfSolvers() {
        Chart map = chart(false, series(Look.REFERENCE, "imaginary axis", 1, 2), series(look("rk4"), "rk4", 1, 2));
        LegendItemCollection legend = Charts.legend(Charts.plots(Charts.of(Panel.map("title", map), true,
                ChartFormat.PAGE)), ChartFormat.PAGE).getSources()[0].getLegendItems();
        assertEquals(List.of("rk4", "imaginary axis"), List.of(legend.get(0).getLabel(), legend.get(1).getLabel()));
    }

    /** Of two charts beside each other, one may have a run that failed where the other has a result. */
    @Test
    void aRunWithoutAValueHasItsPlaceOnTheAxis() {
        assertTrue(plot(true, series("mine", 1, 1, Double.NaN)).getDomainAxis().getRange().contains(3));
    }

    /** Ticks are 1, 2 or 5 times a power of ten apart, and their labels have no round-off. */
    @ParameterizedTest
    @CsvSource({"0, 2.1e-14, 0; 5e-15; 1e-14; 1.5e-14; 2e-14", "0, 1, 0; 0.2; 0.4; 0.6; 0.8; 1",
        "0, 8, 0; 2; 4; 6; 8", "0, 2000, 0; 500; 1000; 1500; 2000"})
    void ticksHaveTheDigitsTheyNeed(double low, double high, String labels) {
        ValueAxis axis = Axes.of(Axis.linear("x", "m"), new Range(low, high), true, 5);
        List<?> ticks = axis.refreshTicks(new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB).createGraphics(),
                new AxisState(), new Rectangle2D.Double(0, 0, 500, 400), RectangleEdge.BOTTOM);
        assertEquals(labels, ticks.stream().map(tick -> ((ValueTick) tick).getText())
                .filter(text -> !text.isEmpty()).collect(Collectors.joining("; ")));
    }

    /** Powers of ten are evenly apart; an axis with few of them has digits between, and one with none decimals. */
    @ParameterizedTest
    @CsvSource({"1e-17, 1e3, 1e-15 1e-12 1e-9 1e-6 0.001 1 1000", "0.5, 2e6, 1 10 100 1000 10000 1e5 1e6",
        "4e-3, 6e-2, 0.005 0.01 0.02 0.05", "1.2, 1.8, 1.2 1.3 1.4 1.5 1.6 1.7 1.8"})
    void logarithmicTicksAreEven(double low, double high, String labels) {
        assertEquals(labels, DoubleStream.of(DecadeAxis.ticks(new Range(low, high), 8)).mapToObj(Axes::text)
                .collect(Collectors.joining(" ")));
    }

    /** A half-empty axis says nothing: it begins at the data, with a twentieth beside it for marks. */
    @Test
    void aLogarithmicAxisBeginsAtTheData() {
        Range range = plot(true, series("y", 1.5e-3, 2)).getRangeAxis().getRange();
        double beside = Math.pow(2 / 1.5e-3, 0.05);
        assertEquals(1.5e-3 / beside, range.getLowerBound(), 1e-9);
        assertEquals(2 * beside, range.getUpperBound(), 1e-9);
    }

    /** Where all runs have the same result, up to round-off, the ticks beside them still differ. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 1, 50, -2e-7})
    void oneValueHasAnAxisWithDifferentTicks(double value) {
        Range range = plot(false, series("y", value, value * (1 + 1e-15))).getRangeAxis().getRange();
        assertTrue(range.contains(value));
        assertTrue(range.getLength() >= Math.abs(value) && range.getLength() > 0, range.toString());
    }

    /** Where no run has a result, the numbers of an axis would be made up. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void anAxisWithoutValuesHasNoNumbers(boolean log) {
        assertFalse(plot(log, series("y", Double.NaN, Double.NaN)).getRangeAxis().isTickLabelsVisible());
        assertTrue(plot(log, series("y", 1, Double.NaN)).getRangeAxis().isTickLabelsVisible());
    }

    /** In state space too; what is no solver's has no solver's colour. */
    @Test
    void pathsHaveTheirSolversColour() {
        for (String solver : List.of("euler", "midpoint", "rk4")) {
            XYPlot plot = path(chart(false, series(look(solver), solver, 1, 2, 3),
                    series(Look.REFERENCE, "exact", 1, 2), Series.point(Look.MARK, "start", Mark.POINTS, 1, 1)),
                    Optional.empty());
            List<Object> paints = IntStream.range(0, 3).mapToObj(k -> (Object) plot.getRenderer().getSeriesPaint(k))
                    .toList();
            assertTrue(paints.contains(new Color(look(solver).rgb())), solver);
            assertEquals(2, paints.stream().filter(ChartStyle.AXIS::equals).count());
        }
        XYPlot plot = path(LectureFigures.exactChart(), Optional.empty());
        assertEquals(ChartStyle.AXIS, plot.getRenderer().getSeriesPaint(0));
        assertEquals(ChartStyle.stroke(1), plot.getRenderer().getSeriesStroke(0), "dashes");
    }

    /** A turn goes there and back, so that 120 of them cross 240 times; how many states they have does not matter. */
    @Test
    void onlyPathsThatCrossThePlotOftenLetShineThrough() {
        Color strong = new Color(look("rk4").rgb());
        for (int states : new int[] {100, 5000}) {
            for (int turns : new int[] {1, 110, 130}) {
                double[] y = new double[states * turns / (states < 1000 ? 1 : turns) + 1];
                for (int k = 0; k < y.length; k++) {
                    y[k] = StrictMath.cos(2 * Math.PI * turns * k / (y.length - 1));
                }
                Series line = series(look("rk4"), "rk4", y);
                XYPlot plot = path(chart(false, new Series(line.look(), "rk4", Mark.LINE, line.x(), line.y())),
                        Optional.empty());
                assertEquals(turns == 130 ? ChartStyle.pale(strong) : strong, plot.getRenderer().getSeriesPaint(0),
                        turns + " turns of " + y.length + " states");
            }
        }
    }

    @Test
    void pathAndFieldAreDrawnAndWritten() throws IOException {
        VectorField field = new VectorField(new double[] {0, 1}, new double[] {0, 1}, new double[] {0, -1, 0, -1});
        // the field, and half a cell around it
        assertEquals(1.5, path(chart(false, series("path", 1, 2, 3)), Optional.of(field)).getDomainAxis()
                .getUpperBound());
        OutputFolder folder = OutputFolder.open(top);
        ChartWriter writer = new ChartWriter(folder, ChartFormat.PAGE);
        writer.write("phase.png", ChartPage.of(Panel.phase("t", chart(false, series("path", 1, 2, 3)),
                Optional.of(field)), ChartFormat.PAGE));
        writer.write("energy.png", ChartPage.of(Panel.of("t", List.of(chart(false, series("a", 0, 0)),
                chart(false, series("b", 0)))), ChartFormat.PAGE));
        writer.write("log.png", ChartPage.of(Panel.of("t", List.of(chart(true, series("nothing", -1, -1)))),
                ChartFormat.PAGE));
        assertEquals(1440, ImageIO.read(top.resolve("phase.png").toFile()).getWidth(), "as wide as high, about");
        assertFalse(Files.exists(top.resolve("energy.svg")));
        assertTrue(Files.size(top.resolve("energy.png")) > 0);
        assertFalse(Files.exists(top.resolve(".phase.png.part")));
    }

    /** A band is a line as well, an area is not. */
    @Test
    void aBandIsNamedAtItsEndAndAnAreaInTheLegend() {
        JFreeChart chart = drawn(chart(true, new Series(Look.OWN, "mine", Mark.BAND, new double[] {1, 2},
                new double[] {1, 1}), new Series(Look.OWN, "stable", Mark.FILL, new double[] {1, 2},
                new double[] {1, 1})));
        List<ChartPlot> plots = Charts.plots(chart);
        assertEquals(List.of("mine"), plots.get(0).ends.labelled.stream().map(k -> ((ChartDataset) plots.get(0)
                .getDataset()).series(k).name()).toList());
        assertEquals("stable", Charts.legend(plots, ChartFormat.PAGE).getSources()[0].getLegendItems().get(0)
                .getLabel());
    }

    @Test
    void exponentsHaveOneStyleOnAllAxes() {
        assertEquals(List.of("100", "0.01", "1e-6", "1e7", "0"), DoubleStream.of(100, 0.01, Math.pow(10, -6), 1e7, 0)
                .mapToObj(Axes::text).toList());
    }
}
