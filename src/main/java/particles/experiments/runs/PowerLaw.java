package particles.experiments.runs;

import java.util.Arrays;

/** Powers fitted to measurements: a straight line in logarithms, by least squares. */
public final class PowerLaw {
    /** The fewest points for a fit; two points always lie on a line. */
    public static final int FEWEST = 3;

    private PowerLaw() {
    }

    /** @return the exponent of y as a power of x; NaN for fewer than three points */
    public static double exponent(double[] x, double[] y) {
        if (x.length < FEWEST) {
            return Double.NaN;
        }
        double meanX = Arrays.stream(x).map(StrictMath::log).average().orElse(0);
        double meanY = Arrays.stream(y).map(StrictMath::log).average().orElse(0);
        double products = 0;
        double squares = 0;
        for (int k = 0; k < x.length; k++) {
            double dx = StrictMath.log(x[k]) - meanX;
            products += dx * (StrictMath.log(y[k]) - meanY);
            squares += dx * dx;
        }
        return products / squares;
    }
}
