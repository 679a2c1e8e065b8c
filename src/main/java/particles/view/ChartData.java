package particles.view;

import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;

/**
 * The data and labels of a chart, independent of how it is drawn.
 *
 * @param title  the finding, or what is shown; empty if there is nothing to say
 * @param xLabel the quantity along x, with its unit
 * @param yLabel the quantity along y, with its unit
 * @param xLog   whether x is logarithmic
 * @param yLog   whether y is logarithmic
 * @param rows   names for y = 0, 1, 2, ..., from the top, if y is not a quantity; otherwise empty
 * @param series the lines and points
 * @param scale  the series whose ranges the axes show: its own, or those of the charts with which it is compared
 */
public record ChartData(String title, String xLabel, String yLabel, boolean xLog, boolean yLog, List<String> rows,
                        List<Series> series, List<Series> scale) {

    /**
     * Creates a chart in which x and y are quantities.
     *
     * @param title  the finding, or what is shown
     * @param xLabel the quantity along x, with its unit
     * @param yLabel the quantity along y, with its unit
     * @param xLog   whether x is logarithmic
     * @param yLog   whether y is logarithmic
     * @param series the lines and points
     */
    public ChartData(String title, String xLabel, String yLabel, boolean xLog, boolean yLog, List<Series> series) {
        this(title, xLabel, yLabel, xLog, yLog, List.of(), series, series);
    }

    /** @return the chart with another title */
    public ChartData titled(String title) {
        return new ChartData(title, xLabel, yLabel, xLog, yLog, rows, series, scale);
    }

    /** @return the chart with names for y = 0, 1, 2, ..., as y is no quantity */
    public ChartData inRows(List<String> names) {
        return with(names, series);
    }

    /**
     * Adds a row for each item below this chart, over the same x axis.
     *
     * @param yLabel the label of the rows
     * @param rows   their names
     * @param series points (x, row), of which those without any are left out
     * @return this chart, and the rows if there are points in them
     */
    public List<ChartData> above(String yLabel, List<String> rows, List<Series> series) {
        List<Series> drawn = series.stream().filter(one -> one.x().length > 0).toList();
        return drawn.isEmpty() ? List.of(this)
                : List.of(this, new ChartData("", xLabel, yLabel, xLog, false, drawn).inRows(rows));
    }

    /** @return a part of the chart, on the same axes */
    public ChartData with(List<String> names, List<Series> drawn) {
        return new ChartData(title, xLabel, yLabel, xLog, yLog, names, drawn, scale);
    }

    /** @return the chart on the axes that these series would have */
    public ChartData scaledTo(List<Series> others) {
        return new ChartData(title, xLabel, yLabel, xLog, yLog, rows, series, others);
    }

    /** The ways of drawing a series. */
    public enum Mark {
        /** A line without points. */
        LINE,
        /** A wide pale line, below others that may run along it. */
        BAND,
        /** Points without a line. */
        POINTS,
        /** Hollow points without a line. */
        OPEN_POINTS,
        /** A line with points. */
        LINE_AND_POINTS,
        /** A line with hollow points, so that filled points on top of some of them stand out. */
        LINE_AND_OPEN_POINTS,
        /** Thin straight lines, with gaps between them: the spread of a measurement. */
        BARS,
        /** Crosses, for failed runs. */
        FAILURES,
        /** Rings, for runs that were given up. */
        GIVEN_UP,
    }

    /**
     * One line of a chart.
     *
     * @param name the name in the legend; if it begins with a solver's name, the series has that solver's colour and
     *             mark in all charts, and other series beside it are grey
     * @param mark the way of drawing it
     * @param x    the abscissae
     * @param y    the ordinates, as many as x has entries
     */
    public record Series(String name, Mark mark, double[] x, double[] y) {
        /** @return the series with a point for each item */
        public static <T> Series of(String name, Mark mark, List<T> items, ToDoubleFunction<? super T> x,
                ToDoubleFunction<? super T> y) {
            return new Series(name, mark, items.stream().mapToDouble(x).toArray(),
                    items.stream().mapToDouble(y).toArray());
        }

        /** @return a series of points (x, y) */
        public static Series of(String name, Mark mark, List<double[]> points) {
            return of(name, mark, points, point -> point[0], point -> point[1]);
        }

        /** @return a series of one point */
        public static Series point(String name, Mark mark, double x, double y) {
            return new Series(name, mark, new double[] {x}, new double[] {y});
        }
    }

    /**
     * The vector field ds/dt of one degree of freedom over its state space: the arrows on the slide "Vectors show the
     * vector field" for s = (x, v). Arrow k stands at (x[k], v[k]) and points along (v[k], dv[k]).
     *
     * @param x  positions (m)
     * @param v  velocities (m/s)
     * @param dv rates of the velocities, the accelerations (m/s&sup2;)
     */
    public record VectorField(double[] x, double[] v, double[] dv) {
        /** @return arrows at all pairs of these positions and velocities, with accelerations of 0 as yet */
        public static VectorField over(double[] positions, double[] velocities) {
            int n = positions.length * velocities.length;
            double[] x = IntStream.range(0, n).mapToDouble(k -> positions[k % positions.length]).toArray();
            double[] v = IntStream.range(0, n).mapToDouble(k -> velocities[k / positions.length]).toArray();
            return new VectorField(x, v, new double[n]);
        }
    }
}
