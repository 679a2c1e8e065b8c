package deSolvers.extrapolation;

import static deSolvers.problems.Bounds.assertAbove;
import static deSolvers.problems.KnownSolutions.testEquation;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.StepTransaction;
import deSolvers.problems.ReferenceProblem;
import org.junit.jupiter.api.Test;

/** The extrapolation table for s' = lambda s over 1 s: the columns' stability functions and error estimates. */
class ExtrapolationTableTest {
    /** Moduli of a column's result, its error estimate, and the estimate without smoothing. */
    private record Column(double result, double estimate, double correction, double smoothing) {
    }

    /** From s = 1 with lambda = re + i im, as a system of two: all columns, from the second on. */
    private static Column[] cover(double re, double im) {
        ReferenceProblem problem = testEquation(re, im);
        ModifiedMidpoint midpoint = new ModifiedMidpoint();
        ExtrapolationTable results = new ExtrapolationTable();
        ExtrapolationTable smoothings = new ExtrapolationTable();
        midpoint.resize(2);
        results.resize(2);
        smoothings.resize(2);
        Column[] columns = new Column[OrderControl.COLUMNS];
        double[] error = new double[2];
        try (StepTransaction step = new StepTransaction(BulirschStoerSolver.class).begin(problem, 1)) {
            for (int j = 0; j < columns.length; j++) {
                midpoint.begin(new double[] {1, 0}, new double[] {re, im}, 0, 1);
                midpoint.cover(step, OrderControl.substeps(j), results.begin(j), smoothings.begin(j));
                results.extrapolate(j);
                smoothings.extrapolate(j);
                BulirschStoerSolver.estimate(results, smoothings, error);
                columns[j] = new Column(modulus(results.result()), modulus(error), modulus(results.getCorrection()),
                        modulus(smoothings.result()));
            }
        }
        return columns;
    }

    private static double modulus(double[] vector) {
        return Math.hypot(vector[0], vector[1]);
    }

    /** The limits on the negative real axis that javadoc states. */
    @Test
    void stabilityLimitsAreThoseOfTheJavadoc() {
        double[] limits = {0, 5.0203, 7.3630, 6.3878, 7.2746, 8.2518, 9.2626, 10.2897, 11.3256};
        for (int k = 1; k < limits.length; k++) {
            assertTrue(cover(2e-4 - limits[k], 0)[k].result() < 1, "column " + k);
            assertTrue(cover(-2e-4 - limits[k], 0)[k].result() > 1, "column " + k);
            for (double x = 0.05; x < limits[k] - 2e-4; x += 0.05) {
                assertTrue(cover(-x, 0)[k].result() < 1, "column " + k + " at " + x);
            }
        }
    }

    /**
     * Over the left half of the plane, wherever a result grows by more than a twentieth: measured 4.8 to 74 times the
     * estimate, but up to 2e6 times what the last column changed alone; on the real axis at most 0.67 times what is
     * left of the smoothing.
     */
    @Test
    void theEstimateDetectsGrowingResults() {
        double blindest = 0;
        for (int angle = 0; angle <= 15; angle++) {
            double phi = Math.PI / 2 * (1 + angle / 15.0);
            for (double size = 1; size < 30; size += 0.03) {
                Column[] columns = cover(size * Math.cos(phi), size * Math.sin(phi));
                for (int k = 1; k < columns.length; k++) {
                    Column column = columns[k];
                    String where = "column " + k + " at " + size + ", angle " + 6 * angle;
                    if (column.result() > 1.05) {
                        assertTrue(column.result() < 100 * column.estimate(), where + ": " + column);
                        assertTrue(angle < 15 || column.result() < column.smoothing(), where + ": " + column);
                        blindest = Math.max(blindest, column.result() / column.correction());
                    }
                }
            }
        }
        assertAbove(1e5, blindest, "without the smoothing");
    }

    /** Where the table converges the smoothing tends to 0 as well, and does not decide. */
    @Test
    void forShortStretchesTheLastColumnDecides() {
        Column[] columns = cover(-0.5, 0);
        for (int k = 1; k <= 3; k++) {
            assertEquals(columns[k].correction(), columns[k].estimate(), "column " + k);
            // Measured 0.27 to 0.44 of it.
            assertTrue(columns[k].smoothing() < 0.6 * columns[k].correction(), "column " + k + ": " + columns[k]);
        }
    }
}
