package particles.view;

import deSolvers.text.Digits;
import java.util.Arrays;
import java.util.List;
import java.util.function.ToDoubleFunction;

/**
 * One line of a chart, or one kind of points.
 *
 * @param look the colour, dashes and points
 * @param name the name at its end or in the legend
 * @param mark the way of drawing it
 * @param x    the abscissae; NaN where a line is cut
 * @param y    the ordinates, as many as x has entries
 * @param end  the number that stands beside the name, with its unit, such as the last value; may be empty
 */
public record Series(Look look, String name, Mark mark, double[] x, double[] y, String end) {
    /** Lines that turn more often than this, by this part of their range or more, fill an area. */
    private static final int DENSE = 240;
    private static final double SEEN = 0.02;
    /** A last value below this part of the largest one is round-off. */
    private static final double ROUND_OFF = 1e-12;

    /** The ways of drawing a series. */
    public enum Mark {
        /** A line without points. */
        LINE,
        /** A wide pale line, below others that may run along it. */
        BAND,
        /** A pale area: the points that an odd number of closed lines go around. */
        FILL,
        /** Points without a line. */
        POINTS,
        /** Hollow points without a line. */
        OPEN_POINTS,
        /** A line with points. */
        LINE_AND_POINTS,
        /** Crosses, for failed runs. */
        FAILURES;

        /** @return whether it is a curve, which can have its name at its end */
        public boolean isCurve() {
            return this == LINE || this == BAND || this == LINE_AND_POINTS;
        }

        /** @return whether it is wide and pale, with everything else on top */
        public boolean isWide() {
            return this == BAND || this == FILL;
        }
    }

    /** @throws IllegalArgumentException if there are not as many x as y */
    public Series {
        if (x.length != y.length) {
            throw new IllegalArgumentException("series '" + name + "' has " + x.length + " x and " + y.length + " y");
        }
    }

    /** Creates a series without a number beside its name. */
    public Series(Look look, String name, Mark mark, double[] x, double[] y) {
        this(look, name, mark, x, y, "");
    }

    /** @return a series with a point for each item */
    public static <T> Series of(Look look, String name, Mark mark, List<T> items, ToDoubleFunction<? super T> x,
            ToDoubleFunction<? super T> y) {
        return new Series(look, name, mark, items.stream().mapToDouble(x).toArray(),
                items.stream().mapToDouble(y).toArray());
    }

    /** @return a series of points (x, y) */
    public static Series of(Look look, String name, Mark mark, List<double[]> points) {
        return of(look, name, mark, points, point -> point[0], point -> point[1]);
    }

    /** @return a series of one point */
    public static Series point(Look look, String name, Mark mark, double x, double y) {
        return new Series(look, name, mark, new double[] {x}, new double[] {y});
    }

    /** @return the series with this number beside its name */
    public Series ending(String number) {
        return new Series(look, name, mark, x, y, number);
    }

    /** @return the series with its last y and its unit beside its name; on a linear axis round-off is 0 */
    public Series ending(Axis axis) {
        int last = last();
        double largest = Arrays.stream(y).map(Math::abs).filter(Double::isFinite).max().orElse(0);
        boolean none = last >= 0 && !axis.log() && Math.abs(y[last]) < ROUND_OFF * largest;
        return ending(last < 0 ? "" : (Digits.few(none ? 0 : y[last]) + " " + axis.unit()).strip());
    }

    /** @return the index of the last point that is finite; -1 if there is none */
    public int last() {
        int k = x.length - 1;
        while (k >= 0 && !(Double.isFinite(x[k]) && Double.isFinite(y[k]))) {
            k--;
        }
        return k;
    }

    /** @return whether these values turn up and down so often that a line through them would fill an area */
    public static boolean isDense(double[] values) {
        double[] finite = Arrays.stream(values).filter(Double::isFinite).toArray();
        double low = Arrays.stream(finite).min().orElse(0);
        double seen = SEEN * (Arrays.stream(finite).max().orElse(0) - low);
        int turns = 0;
        boolean up = true;
        double turn = low;                              // the last extreme in this direction
        for (double value : finite) {
            if (up == value > turn) {
                turn = value;
            } else if (Math.abs(value - turn) > seen) {
                turns++;
                up = !up;
                turn = value;
            }
        }
        return turns > DENSE;
    }
}
