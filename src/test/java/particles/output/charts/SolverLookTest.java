package particles.output.charts;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.catalog.SolverCatalog;
import java.awt.Color;
import java.awt.color.ColorSpace;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.jfree.chart.renderer.xy.XYItemRenderer;
import org.junit.jupiter.api.Test;
import particles.view.Axis;
import particles.view.Chart;
import particles.view.Look;
import particles.view.Panel;
import particles.view.Series;
import particles.view.Series.Mark;

/** The looks of the catalogue's solvers, which are distinct for all eyes. */
class SolverLookTest {
    private static Look look(String name) {
        return Look.of(SolverCatalog.info(name));
    }

    private static Color colour(String name) {
        return new Color(look(name).rgb());
    }

    @Test
    void everySolverHasALookOfItsOwnInLinesAndInPoints() {
        Set<List<Object>> lines = new HashSet<>();
        Set<List<Object>> points = new HashSet<>();
        for (String name : SolverCatalog.names()) {
            assertTrue(lines.add(List.of(colour(name), ChartStyle.stroke(look(name).variant()))), name);
            assertTrue(points.add(List.of(colour(name), ChartStyle.shape(look(name).variant()))), name);
        }
    }

    /** G. M. Machado, M. M. Oliveira, L. A. F. Fernandes 2009, severity 1: red-blind, green-blind, blue-blind. */
    private static final double[][][] VISION = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
        {{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}},
        {{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}},
        {{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}};

    /**
     * A difference of 2 in CIELAB is just seen. Measured: at least 14 between any two of a family, for every kind of
     * colour vision, and a difference in lightness, which grey print keeps, of at least 12.
     */
    @Test
    void aFamilyIsToldApartWithAnyColourVisionAndInGreyPrint() {
        for (String one : SolverCatalog.names()) {
            for (String other : SolverCatalog.names()) {
                if (one.compareTo(other) < 0 && SolverCatalog.info(one).family().group()
                        == SolverCatalog.info(other).family().group()) {
                    for (double[][] vision : VISION) {
                        double[] a = lab(look(one).rgb(), vision);
                        double[] b = lab(look(other).rgb(), vision);
                        double distance = Math.sqrt(Math.pow(a[0] - b[0], 2) + Math.pow(a[1] - b[1], 2)
                                + Math.pow(a[2] - b[2], 2));
                        assertTrue(distance > 12, one + " and " + other + ": " + distance);
                    }
                    double lightness = Math.abs(lab(look(one).rgb(), VISION[0])[0]
                            - lab(look(other).rgb(), VISION[0])[0]);
                    assertTrue(lightness > 11, one + " and " + other + " in grey: " + lightness);
                }
            }
        }
    }

    /** CIELAB of an sRGB colour as somebody with this vision sees it. */
    private static double[] lab(int rgb, double[][] vision) {
        float[] linear = ColorSpace.getInstance(ColorSpace.CS_LINEAR_RGB).fromRGB(new Color(rgb)
                .getRGBColorComponents(null));
        double[] seen = new double[3];
        for (int k = 0; k < 3; k++) {
            seen[k] = Math.max(0, Math.min(1, vision[k][0] * linear[0] + vision[k][1] * linear[1]
                    + vision[k][2] * linear[2]));
        }
        double x = root((0.4124 * seen[0] + 0.3576 * seen[1] + 0.1805 * seen[2]) / 0.9505);
        double y = root(0.2126 * seen[0] + 0.7152 * seen[1] + 0.0722 * seen[2]);
        double z = root((0.0193 * seen[0] + 0.1192 * seen[1] + 0.9505 * seen[2]) / 1.089);
        return new double[] {116 * y - 16, 500 * (x - y), 200 * (y - z)};
    }

    private static double root(double t) {
        return t > 0.008856 ? Math.cbrt(t) : 7.787 * t + 16.0 / 116;
    }

    @Test
    void aSolverLooksTheSameWhereverItStands() {
        Series line = new Series(Look.REFERENCE, "order 4", Mark.LINE, new double[] {1, 2}, new double[] {1, 2});
        Series rk4 = new Series(look("rk4"), "rk4", Mark.LINE_AND_POINTS, new double[] {1, 2}, new double[] {1, 3});
        Series verlet = new Series(look("verlet"), "verlet", Mark.LINE, new double[] {1, 2}, new double[] {1, 4});
        XYItemRenderer renderer = Charts.of(Panel.of("", List.of(new Chart(Axis.TIME, Axis.TIME, List.of(line, rk4,
                verlet)))), false, ChartFormat.PAGE).getXYPlot().getRenderer();
        assertEquals(colour("verlet"), renderer.getSeriesPaint(0), "without dashes, so below those with some");
        assertEquals(ChartStyle.stroke(0), renderer.getSeriesStroke(0));
        assertEquals(ChartStyle.AXIS, renderer.getSeriesPaint(1));
        assertEquals(colour("rk4"), renderer.getSeriesPaint(2));
        assertEquals(ChartStyle.shape(look("rk4").variant()), renderer.getSeriesShape(2));
    }
}
