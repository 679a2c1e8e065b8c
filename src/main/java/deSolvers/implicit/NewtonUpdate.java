package deSolvers.implicit;

/**
 * What Newton's method adds to its unknowns: the solution of the linearised equation, and how large that is beside
 * them.
 */
final class NewtonUpdate {
    /** Entries smaller than this part of the largest are judged as if they were as large as that. */
    private static final double SMALL_ENTRY = 1e-3;

    private static final double SMALLEST_UNSCALED = 1e-100;
    private static final double LARGEST_UNSCALED = 1e100;

    private NewtonUpdate() {
    }

    /**
     * Solves the linearised equation. A residual whose square would under- or overflow is scaled for the linear solver.
     *
     * @param residual r(u); unchanged but for roundings
     * @param result   receives the correction
     * @return false if there is none
     */
    static boolean compute(NewtonProblem problem, double[] residual, double[] result) {
        double largest = largest(residual);
        if (largest > SMALLEST_UNSCALED && largest < LARGEST_UNSCALED || largest == 0) {
            return problem.correct(residual, result);
        }
        for (int i = 0; i < residual.length; i++) {
            residual[i] /= largest;
        }
        boolean solved = problem.correct(residual, result);
        for (int i = 0; i < residual.length; i++) {
            residual[i] *= largest;
            result[i] *= largest;
        }
        return solved;
    }

    /**
     * Measures a correction.
     *
     * @param u     the unknowns that it is for
     * @param first how large they were at the beginning
     * @return its largest entry relative to the unknown that it corrects; infinite where that leaves the numbers
     */
    static double size(double[] correction, double[] u, double[] first) {
        double largest = 0;
        for (int i = 0; i < u.length; i++) {
            largest = Math.max(largest, magnitude(correction, u, first, i));
        }
        if (!(largest <= Double.MAX_VALUE)) {
            return Double.POSITIVE_INFINITY;            // nothing is small beside a number that is none
        }
        double size = 0;
        for (int i = 0; i < u.length; i++) {
            if (correction[i] != 0) {
                double magnitude = Math.max(magnitude(correction, u, first, i), SMALL_ENTRY * largest);
                size = Math.max(size, Math.abs(correction[i]) / magnitude);
            }
        }
        return size;
    }

    /**
     * Measures a correction with every unknown by itself, however small it is beside others.
     *
     * @param u     the unknowns that it is for
     * @param first how large they were at the beginning
     * @return its largest entry relative to the unknown that it corrects; infinite where that leaves the numbers
     */
    static double ownSize(double[] correction, double[] u, double[] first) {
        double size = 0;
        for (int i = 0; i < u.length; i++) {
            if (correction[i] != 0) {
                size = Math.max(size, Math.abs(correction[i]) / magnitude(correction, u, first, i));
            }
        }
        return size <= Double.MAX_VALUE ? size : Double.POSITIVE_INFINITY;
    }

    /** The unknown before the correction, after it, and at the beginning: the largest of the three. */
    private static double magnitude(double[] correction, double[] u, double[] first, int i) {
        return Math.max(Math.max(Math.abs(u[i]), Math.abs(u[i] + correction[i])), Math.abs(first[i]));
    }

    /** The largest entry by its size; NaN if one is. */
    static double largest(double[] values) {
        double largest = 0;
        for (double value : values) {
            largest = Math.max(largest, Math.abs(value));
        }
        return largest;
    }
}
