package particles.experiments.phase;

import java.util.Arrays;

/** The distance of a path in state space from a curve, by shape alone: times are not compared. */
final class CurveDistance {
    /** The largest number of points used of a path, and of lines of the curve: enough for a few turns, and fast. */
    private static final int MOST_POINTS = 600;
    private static final int MOST_LINES = 6000;

    private final double[] x;
    private final double[] v;
    private final double middleX;
    private final double middleV;
    private final double reachX;
    private final double reachV;

    /**
     * @param x positions along the curve
     * @param v the velocities at these positions
     */
    CurveDistance(double[] x, double[] v) {
        this.x = x;
        this.v = v;
        middleX = (lowest(x) + highest(x)) / 2;
        middleV = (lowest(v) + highest(v)) / 2;
        reachX = (highest(x) - lowest(x)) / 2;
        reachV = (highest(v) - lowest(v)) / 2;
    }

    /** @return whether there is no curve: the particle is at rest, or moves with constant velocity */
    boolean isDegenerate() {
        return !(reachX > 0 && reachV > 0);
    }

    /** @return whether the particle does not move at all */
    boolean isAtRest() {
        return reachX == 0 && reachV == 0;
    }

    /**
     * @return the distance of a state from the middle of the box around the curve: 1 at its edges; NaN if there is no
     *         box
     */
    double outwards(double position, double velocity) {
        return isDegenerate() ? Double.NaN
                : Math.max(Math.abs(position - middleX) / reachX, Math.abs(velocity - middleV) / reachV);
    }

    /**
     * @param pathX positions along a path
     * @param pathV the velocities at these positions
     * @return the largest distance of its points from the curve, in halves of the curve's width and height; NaN if it
     *         has
     * none
     */
    double largest(double[] pathX, double[] pathV) {
        if (isDegenerate()) {
            return Double.NaN;
        }
        double largest = 0;
        int skip = Math.max(1, pathX.length / MOST_POINTS);
        for (int k = pathX.length - 1; k >= 0; k -= skip) {
            largest = Math.max(largest, of(pathX[k], pathV[k]));
        }
        return largest;
    }

    private double of(double position, double velocity) {
        double nearest = Double.POSITIVE_INFINITY;
        int skip = Math.max(1, x.length / MOST_LINES);
        for (int k = 0; k + 1 < x.length; k += skip) {
            int next = Math.min(k + skip, x.length - 1);
            double ax = (x[k] - position) / reachX;
            double av = (v[k] - velocity) / reachV;
            double bx = (x[next] - x[k]) / reachX;
            double bv = (v[next] - v[k]) / reachV;
            double square = bx * bx + bv * bv;
            double along = square > 0 ? Math.max(0, Math.min(1, -(ax * bx + av * bv) / square)) : 0;
            double dx = ax + along * bx;
            double dv = av + along * bv;
            nearest = Math.min(nearest, dx * dx + dv * dv);
        }
        return Math.sqrt(nearest);
    }

    private static double lowest(double[] values) {
        return Arrays.stream(values).min().orElse(Double.POSITIVE_INFINITY);
    }

    private static double highest(double[] values) {
        return Arrays.stream(values).max().orElse(Double.NEGATIVE_INFINITY);
    }
}
