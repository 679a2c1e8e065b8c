package particles.experiments.energy;

import particles.energy.MinMaxThinning;

/**
 * An energy error over time, and the straight line that fits it best. It keeps running sums, so that every value counts
 * and none is stored.
 */
final class ErrorCurve {
    private static final int BUCKETS = 512;

    private final MinMaxThinning error = new MinMaxThinning(BUCKETS);
    private double n;
    private double meanTime;
    private double meanError;
    private double timeSquares;
    private double errorSquares;
    private double products;

    /** Updates the means and the sums of squares about them (B. P. Welford, Technometrics 4, 1962). */
    void add(double time, double value) {
        if (!Double.isFinite(value)) {
            return;
        }
        error.add(time, value);
        n++;
        double dTime = time - meanTime;
        double dError = value - meanError;
        meanTime += dTime / n;
        meanError += dError / n;
        timeSquares += dTime * (time - meanTime);
        errorSquares += dError * (value - meanError);
        products += dTime * (value - meanError);
    }

    double[][] points() {
        return error.points();
    }

    /** @return the largest error before a time, and the largest from then on (J) */
    double[] halves(double middle) {
        double[][] points = error.points();
        double[] largest = new double[2];
        for (int k = 0; k < points[0].length; k++) {
            int half = points[0][k] < middle ? 0 : 1;
            largest[half] = Math.max(largest[half], Math.abs(points[1][k]));
        }
        return largest;
    }

    double end() {
        return error.getLast();
    }

    double largest() {
        return Math.max(Math.abs(error.largest()), Math.abs(error.smallest()));
    }

    /** @return joules a second; 0 before the first step */
    double slope() {
        return timeSquares > 0 ? products / timeSquares : 0;
    }

    /** @return the root mean square distance of the values from the straight line (J) */
    double scatter() {
        return n < 3 ? 0 : Math.sqrt(Math.max(0, errorSquares - slope() * products) / n);
    }
}
