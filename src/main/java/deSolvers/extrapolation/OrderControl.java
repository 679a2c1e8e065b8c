package deSolvers.extrapolation;

import static deSolvers.adaptive.AdaptiveSolver.root;

/**
 * Order and step-size control: chooses the number of results to extrapolate and the length of the stretch, with the
 * fewest evaluations per unit of time (Hairer, N&oslash;rsett, Wanner, section II.9, "order and step size control").
 * Columns of the table are counted from 0. The target column k is expected to be accurate enough; k - 1 and k + 1 are
 * accepted too.
 */
final class OrderControl {
    static final int COLUMNS = 9;

    /** The decision after a column. */
    enum Verdict { CONTINUE, ACCEPT, REJECT }

    private static final double SAFETY = 0.94;
    private static final double ERROR_AIM = 0.65;
    private static final double EDGE = 0.02;            // limits changes of the stretch, to the power 1/(2k+1)
    private static final double MOST_SHRINKING = 4;
    private static final double ONE_DOWN = 0.8;         // a lower column is taken if it costs so much less
    private static final double ONE_UP = 0.9;

    private final int[] cost = new int[COLUMNS];        // evaluations up to a column
    private final double[] best = new double[COLUMNS];  // the stretch with which a column would just be good enough
    private final double[] work = new double[COLUMNS];  // evaluations for a unit of time then
    private int target;
    private boolean afterRejection;
    private double next;

    OrderControl() {
        int evaluations = 1;                            // the derivative at the beginning
        for (int k = 0; k < COLUMNS; k++) {
            evaluations += substeps(k);
            cost[k] = evaluations;
        }
    }

    /** 2, 6, 10, ...: with differences of 4, the derivatives at the middle can be extrapolated as well. */
    static int substeps(int column) {
        return 4 * column + 2;
    }

    /** Sets the first target from the tolerance: about one column per 1.7 digits. */
    void restart(double relativeTolerance) {
        double digits = relativeTolerance > 0 ? -StrictMath.log10(relativeTolerance) : 12;
        target = (int) Math.max(1, Math.min(COLUMNS - 3, Math.floor(0.6 * digits - 0.5)));
        afterRejection = false;
    }

    /** The exponent of the error of the target column. */
    int targetExponent() {
        return 2 * target + 1;
    }

    /**
     * Decides by a column's error.
     *
     * @param k     the column, 1 or more
     * @param error the error in units of the tolerance; infinite if something is not finite
     * @param h     the stretch tried, &gt; 0 (s)
     */
    Verdict column(int k, double error, double h) {
        int exponent = 2 * k + 1;
        double edge = root(EDGE, exponent);
        double factor = Math.max(edge / MOST_SHRINKING, Math.min(1 / edge, SAFETY * root(ERROR_AIM / error, exponent)));
        best[k] = h * factor;
        work[k] = cost[k] / best[k];
        if (!(error <= Double.MAX_VALUE)) {
            return reject(k);
        }
        if (k < target - 1) {
            return Verdict.CONTINUE;
        }
        if (error <= 1) {
            accept(k);
            return Verdict.ACCEPT;
        }
        return k <= target && k + 1 < COLUMNS && error <= hope(k) ? Verdict.CONTINUE : reject(k);
    }

    /** The largest error in column k with which the last allowed column, target + 1, can be expected to be accepted. */
    private double hope(int k) {
        double hope = 1;
        for (int j = k + 1; j <= Math.min(target + 1, COLUMNS - 1); j++) {
            double ratio = (double) substeps(j) / substeps(0);
            hope *= ratio * ratio;
        }
        return hope;
    }

    private void accept(int k) {
        int order = k;
        if (k > 1 && work[k - 1] < ONE_DOWN * work[k]) {
            order = k - 1;
        } else if (k + 1 < COLUMNS && !afterRejection && (k == 1 || work[k] < ONE_UP * work[k - 1])) {
            order = k + 1;
        }
        order = Math.min(order, afterRejection ? target : target + 1);
        next = order <= k ? best[order] : best[k] * cost[order] / cost[k];
        target = Math.min(order, COLUMNS - 2);
        afterRejection = false;
    }

    private Verdict reject(int k) {
        int order = Math.min(k, target);
        if (order > 1 && work[order - 1] < ONE_DOWN * work[order]) {
            order--;
        }
        next = best[order];
        target = order;
        afterRejection = true;
        return Verdict.REJECT;
    }

    /** @return the next stretch after the last verdict, &gt; 0 (s) */
    double getNext() {
        return next;
    }
}
