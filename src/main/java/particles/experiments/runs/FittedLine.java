package particles.experiments.runs;

import java.util.Arrays;
import java.util.List;
import java.util.function.ToDoubleFunction;

/** The straight line that fits points best, by least squares. */
public final class FittedLine {
    /** The fewest points for a fitted power; two points always lie on a line. */
    public static final int FEWEST = 3;

    private FittedLine() {
    }

    /** @return the slope of the line through the points (x, y); 0 where all x are equal */
    public static double slope(double[] x, double[] y) {
        double meanX = Arrays.stream(x).average().orElse(0);
        double meanY = Arrays.stream(y).average().orElse(0);
        double squares = 0;
        double products = 0;
        for (int k = 0; k < x.length; k++) {
            squares += (x[k] - meanX) * (x[k] - meanX);
            products += (x[k] - meanX) * (y[k] - meanY);
        }
        return squares > 0 ? products / squares : 0;
    }

    /**
     * Fits a power: a straight line in logarithms.
     *
     * @return the exponent of y as a power of x; NaN for fewer than three points
     */
    public static <T> double exponent(List<T> points, ToDoubleFunction<? super T> x, ToDoubleFunction<? super T> y) {
        return points.size() < FEWEST ? Double.NaN
                : slope(points.stream().mapToDouble(x).map(StrictMath::log).toArray(),
                points.stream().mapToDouble(y).map(StrictMath::log).toArray());
    }
}
