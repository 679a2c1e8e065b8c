package particles.output.charts;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.LegendItemCollection;
import org.jfree.chart.axis.LogAxis;
import org.jfree.chart.axis.SymbolAxis;
import org.jfree.chart.axis.TickUnit;
import org.jfree.chart.axis.ValueAxis;
import org.jfree.chart.plot.CombinedDomainXYPlot;
import org.jfree.chart.plot.XYPlot;
import org.jfree.data.xy.XYDataset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import particles.experiments.lecture.LectureFigures;
import particles.output.files.OutputFolder;
import particles.view.ChartData;
import particles.view.ChartData.Mark;
import particles.view.ChartData.Series;
import particles.view.ChartData.VectorField;

/** Charts by what they were given to draw; how they look is for eyes. */
class ChartsTest {
    @TempDir
    Path top;

    private static ChartData chart(boolean log, Series... series) {
        return new ChartData("title", "x (m)", "y (s)", log, log, List.of(series));
    }

    private static Series series(String name, double... y) {
        return new Series(name, Mark.LINE_AND_POINTS,
                IntStream.rangeClosed(1, y.length).asDoubleStream().toArray(), y);
    }

    private static XYPlot plot(boolean log, Series... series) {
        return Charts.of(Panel.chart(chart(log, series))).getXYPlot();
    }

    @Test
    void theDatasetIsTheData() {
        JFreeChart chart = Charts.of(Panel.chart(chart(false, series("same", 1, 4, 9), series("same", -1, -2))));
        XYDataset dataset = chart.getXYPlot().getDataset();
        assertEquals(2, dataset.getSeriesCount());
        assertEquals(3, dataset.getItemCount(0));
        assertEquals(9, dataset.getYValue(0, 2));
        assertEquals(3, dataset.getXValue(0, 2));
        assertEquals(-2, dataset.getYValue(1, 1));
        assertEquals("title", chart.getTitle().getText());
        assertEquals("x (m)", chart.getXYPlot().getDomainAxis().getLabel());
        assertEquals("y (s)", chart.getXYPlot().getRangeAxis().getLabel());
        assertThrows(IllegalArgumentException.class, () -> Charts.of(Panel.chart(chart(false,
                new Series("short", Mark.LINE, new double[3], new double[2])))));
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
            assertTrue(looks.add(List.of(ChartStyle.colour(k), ChartStyle.stroke(k))), "series " + k);
        }
        for (int k = 1; k < 6; k++) {
            assertNotEquals(ChartStyle.stroke(k), ChartStyle.stroke(k - 1));
            assertNotEquals(ChartStyle.shape(k), ChartStyle.shape(k - 1));
        }
    }

    @Test
    void stackedChartsShareTheirTime() {
        FittedChart chart = stacked(chart(false, series("a", 1, 2), series("b", 1, 2)),
                chart(false, series("drift", 0, 1e-14)));
        CombinedDomainXYPlot plot = assertInstanceOf(CombinedDomainXYPlot.class, chart.getPlot());
        assertEquals(2, plot.getSubplots().size());
        XYPlot below = plot.getSubplots().get(1);
        assertTrue(below.getRangeAxis().getUpperBound() < 1.2e-14, "a small drift fills its axis");
        assertEquals(List.of("a", "b"), chart.labelledNames());
        assertNull(chart.getLegend(), "all names stand in the chart");
    }

    private static FittedChart stacked(ChartData... charts) {
        return Charts.of(Panel.stacked(List.of(charts)));
    }

    /** Runs without a result stand in rows below, named, from above in the order given; the legend has their mark. */
    @Test
    void rowsAreNamedAndFailuresAreInTheLegend() {
        Series hollow = new Series("rk4, 4.00", Mark.LINE_AND_OPEN_POINTS, new double[] {1, 10}, new double[] {1, 2});
        Series filled = new Series("rk4, 4.00", Mark.POINTS, new double[] {10}, new double[] {2});
        ChartData below = new ChartData("", "x (m)", "no result", true, false,
                List.of(new Series("did not converge", Mark.GIVEN_UP, new double[] {1000}, new double[] {1})))
                .inRows(List.of("euler", "rk4"));
        FittedChart chart = stacked(chart(true, hollow, filled), below);
        CombinedDomainXYPlot plot = assertInstanceOf(CombinedDomainXYPlot.class, chart.getPlot());
        SymbolAxis rows = assertInstanceOf(SymbolAxis.class, plot.getSubplots().get(1).getRangeAxis());
        assertEquals(List.of("euler", "rk4"), List.of(rows.getSymbols()));
        assertTrue(rows.isInverted());
        assertTrue(plot.getDomainAxis().getUpperBound() >= 1000, "the axis reaches to the failures");
        LegendItemCollection legend = chart.getLegend().getSources()[0].getLegendItems();
        assertEquals(1, legend.getItemCount(), "rk4 has its name at its end");
        assertEquals("did not converge", legend.get(0).getLabel());
        assertEquals(ChartStyle.GIVEN_UP, legend.get(0).getShape());
        XYPlot above = plot.getSubplots().get(0);
        assertEquals(Color.WHITE, above.getRenderer().getSeriesFillPaint(0));
        assertNotEquals(Color.WHITE, above.getRenderer().getSeriesFillPaint(1));
    }

    @Test
    void ticksHaveTheDigitsTheyNeed() {
        DecimalAxis.Ticks ticks = new DecimalAxis.Ticks();
        TickUnit tiny = ticks.getCeilingTickUnit(1.3e-15);
        assertEquals(2e-15, tiny.getSize());
        assertEquals("-4e-15", tiny.valueToString(-4.0000001e-15));
        assertEquals("0", tiny.valueToString(1e-30));
        assertEquals(5e-15, ticks.getLargerTickUnit(tiny).getSize());
        assertEquals("0.3", ticks.getCeilingTickUnit(0.1).valueToString(0.1 + 0.2));
        assertEquals("2000", ticks.getCeilingTickUnit(400).valueToString(2000));
        assertEquals(500, ticks.getCeilingTickUnit(400).getSize());
    }

    /** In state space too; what is no solver's has no solver's colour. */
    @Test
    void pathsHaveTheirSolversColour() {
        for (String solver : List.of("euler", "midpoint", "rk4")) {
            XYPlot plot = PhasePlot.of(chart(false, series(solver, 1, 2, 3), series("exact", 1, 2), series("start", 1)),
                    Optional.empty()).getXYPlot();
            assertEquals(SolverStyle.of(solver).orElseThrow().colour(), plot.getRenderer().getSeriesPaint(0));
            for (int k = 1; k < 3; k++) {
                assertEquals(ChartStyle.AXIS, plot.getRenderer().getSeriesPaint(k));
            }
        }
        ChartData alone = LectureFigures.exactChart();
        XYPlot plot = PhasePlot.of(alone, Optional.empty()).getXYPlot();
        int exact = alone.series().stream().map(Series::name).toList().indexOf("exact");
        assertEquals(ChartStyle.AXIS, plot.getRenderer().getSeriesPaint(exact));
        assertEquals(ChartStyle.stroke(1), plot.getRenderer().getSeriesStroke(exact), "dashes");
    }

    /** A turn goes there and back, so that 60 of them cross 120 times; how many states they have does not matter. */
    @Test
    void onlyPathsThatCrossThePlotOftenLetShineThrough() {
        Color strong = SolverStyle.of("rk4").orElseThrow().colour();
        for (int states : new int[] {100, 5000}) {
            for (int turns : new int[] {1, 55, 65}) {
                double[] y = new double[states * turns / (states < 1000 ? 1 : turns) + 1];
                for (int k = 0; k < y.length; k++) {
                    y[k] = StrictMath.cos(2 * Math.PI * turns * k / (y.length - 1));
                }
                XYPlot plot = PhasePlot.of(chart(false, series("rk4", y)), Optional.empty()).getXYPlot();
                assertEquals(turns == 65 ? ChartStyle.pale(strong) : strong, plot.getRenderer().getSeriesPaint(0),
                        turns + " turns of " + y.length + " states");
            }
        }
    }

    @Test
    void pathAndFieldAreDrawnAndWritten() throws IOException {
        VectorField field = new VectorField(new double[] {0, 1, 0, 1}, new double[] {0, 0, 1, 1},
                new double[] {0, -1, 0, -1});
        JFreeChart chart = PhasePlot.of(chart(false, series("path", 1, 2, 3), series("start", 1)), Optional.of(field));
        // the field, and half a cell around it
        assertEquals(1.5, chart.getXYPlot().getDomainAxis().getUpperBound());
        OutputFolder folder = OutputFolder.open(top);
        ChartWriter writer = new ChartWriter(folder, ChartFormat.PAGE);
        writer.write("phase.png", ChartPage.of(Panel.phase(chart(false, series("path", 1, 2, 3)), Optional.of(field)),
                ChartFormat.PAGE));
        writer.write("energy.png", ChartPage.of(Panel.stacked(List.of(chart(false, series("a", 0, 0)),
                chart(false, series("b", 0)))), ChartFormat.PAGE));
        writer.write("log.png", ChartPage.of(Panel.chart(chart(true, series("nothing", -1, -1))), ChartFormat.PAGE));
        assertEquals(1440, ImageIO.read(top.resolve("phase.png").toFile()).getWidth(), "as wide as high, about");
        assertFalse(Files.exists(top.resolve("energy.svg")));
        assertTrue(Files.size(top.resolve("energy.png")) > 0);
        assertFalse(Files.exists(top.resolve(".phase.png.part")));
    }

    /** From 0 to 8 in steps of 0.2 both ends have one digit, and the labels between them three characters. */
    @Test
    void labelsBetweenTheEndsHaveRoom() {
        DecimalAxis axis = new DecimalAxis();
        axis.setRange(0, 8);
        Graphics2D g = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB).createGraphics();
        int text = g.getFontMetrics(axis.getTickLabelFont()).stringWidth("0.2");
        double room = axis.estimateMaximumTickLabelWidth(g, new DecimalAxis.Ticks().getCeilingTickUnit(0.2));
        assertTrue(room > text && room < 3 * text, room + " for " + text);
    }

    /** Dampers' work has a fourth one, and two kinds of that differ in their dashes. */
    @Test
    void totalEnergyDrivenWorkAndErrorAreThreeColours() {
        Set<Object> colours = new HashSet<>();
        for (String name : List.of("total", "work: moving anchors", "numerical error",
                "work: drag (dissipated)")) {
            XYPlot plot = plot(false, series(name, 1, 2));
            colours.add(plot.getRenderer().getSeriesPaint(0));
        }
        assertEquals(4, colours.size(), colours.toString());
        XYPlot works = plot(false, series("work: drag (dissipated)", 1, 2),
                series("work: springs (dissipated)", 1, 2));
        assertNotEquals(works.getRenderer().getSeriesStroke(0), works.getRenderer().getSeriesStroke(1));
    }

    /** Bars up to medians have the name of their line, too. */
    @Test
    void aNameHasTheDashesAndPointsOfItsLine() {
        Series bars = new Series("symplectic-euler", Mark.BARS, new double[] {1, 2}, new double[] {1, 1});
        assertEquals(List.of(1), new EndLabels(plot(true, bars, series("symplectic-euler", 1, 2))).labelled);
    }

    @Test
    void exponentsHaveOneStyleOnAllAxes() {
        assertEquals(List.of("100", "0.01", "1e-6", "1e7"), DoubleStream.of(100, 0.01, Math.pow(10, -6), 1e7)
                .mapToObj(new DecadeAxis.PowerFormat()::format).toList());
        ValueAxis axis = plot(true, series("y", 1e-8, 1)).getRangeAxis();
        assertInstanceOf(DecadeAxis.PowerFormat.class, ((LogAxis) axis).getNumberFormatOverride());
    }
}
