package particles.experiments.phase;

import java.util.Arrays;
import java.util.DoubleSummaryStatistics;
import particles.view.Series;

/**
 * The distance of a path in state space from a curve, by shape alone: times are not compared.
 *
 * @param curve      positions along the curve, and the velocities there
 * @param positions  the range of the positions
 * @param velocities the range of the velocities
 */
record CurveDistance(Series curve, DoubleSummaryStatistics positions, DoubleSummaryStatistics velocities) {
    /** The largest number of points used of a path, and of lines of the curve: enough for a few turns, and fast. */
    private static final int MOST_POINTS = 600;
    private static final int MOST_LINES = 6000;

    CurveDistance(Series curve) {
        this(curve, range(curve.x()), range(curve.y()));
    }

    /** @return the range of values, without those where a path is cut */
    static DoubleSummaryStatistics range(double[] values) {
        return Arrays.stream(values).filter(value -> !Double.isNaN(value)).summaryStatistics();
    }

    private static double reach(DoubleSummaryStatistics range) {
        return (range.getMax() - range.getMin()) / 2;
    }

    /** @return whether there is no curve: the particle is at rest, or moves with constant velocity */
    boolean isDegenerate() {
        return !(reach(positions) > 0 && reach(velocities) > 0);
    }

    /** @return whether the particle does not move at all */
    boolean isAtRest() {
        return reach(positions) == 0 && reach(velocities) == 0;
    }

    /**
     * @return the distance of a state from the middle of the box around the curve: 1 at its edges; NaN if there is no
     *         box
     */
    double outwards(double position, double velocity) {
        return isDegenerate() ? Double.NaN : Math.max(outwards(position, positions), outwards(velocity, velocities));
    }

    private static double outwards(double value, DoubleSummaryStatistics range) {
        return Math.abs(value - (range.getMin() + range.getMax()) / 2) / reach(range);
    }

    /**
     * @param path positions along a path, and the velocities there
     * @return the largest distance of its points from the curve, in halves of the curve's width and height; NaN if it
     *         has none
     */
    double largest(Series path) {
        double largest = isDegenerate() ? Double.NaN : 0;
        int skip = Math.max(1, path.x().length / MOST_POINTS);
        for (int k = path.x().length - 1; k >= 0 && largest >= 0; k -= skip) {
            if (!Double.isNaN(path.x()[k])) {           // where the path is cut
                largest = Math.max(largest, of(path.x()[k], path.y()[k]));
            }
        }
        return largest;
    }

    private double of(double position, double velocity) {
        double[] x = curve.x();
        double[] v = curve.y();
        double reachX = reach(positions);
        double reachV = reach(velocities);
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
            if (dx * dx + dv * dv < nearest) {          // false where the curve is cut
                nearest = dx * dx + dv * dv;
            }
        }
        return Math.sqrt(nearest);
    }
}
