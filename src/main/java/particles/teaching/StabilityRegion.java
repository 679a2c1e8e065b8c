package particles.teaching;

import java.util.ArrayList;
import java.util.List;
import particles.ChartData;
import particles.ChartData.Mark;
import particles.ChartData.Series;

/** Where a method with the stability polynomial R(z) is stable: |R(h lambda)| at most 1. */
final class StabilityRegion {
    private static final double ROUNDING = 1e-12;
    private static final double REACH = 16;
    private static final double STEP = 1.0 / 128;

    private StabilityRegion() {
    }

    private static double modulus(double[] r, double re, double im) {
        double x = 0;
        double y = 0;
        for (int k = r.length - 1; k >= 0; k--) {
            double product = x * re - y * im + r[k];
            y = x * im + y * re;
            x = product;
        }
        return Math.sqrt(x * x + y * y);
    }

    /**
     * @param r      the coefficients of R
     * @param degree direction from the origin: 180 is the negative real axis, 90 the imaginary one
     * @return how far from the origin it is stable in that direction
     */
    static double reach(double[] r, double degree) {
        double angle = StrictMath.toRadians(degree);
        double cos = degree == 90 ? 0 : StrictMath.cos(angle);
        double sin = degree == 180 ? 0 : StrictMath.sin(angle);
        double low = 0;
        while (low < REACH && modulus(r, (low + STEP) * cos, (low + STEP) * sin) <= 1 + ROUNDING) {
            low += STEP;
        }
        double high = low + STEP;
        for (int halving = 0; halving < 40; halving++) {
            double middle = (low + high) / 2;
            if (modulus(r, middle * cos, middle * sin) <= 1 + ROUNDING) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return low;
    }

    /** @return the boundary of the region in the left half plane, beside that of RK4 */
    static ChartData chart(String name, double[] r) {
        List<Series> series = new ArrayList<>(List.of(boundary(name, r)));
        series.add(boundary("rk4", new double[] {1, 1, 1.0 / 2, 1.0 / 6, 1.0 / 24}));
        return new ChartData("Stable within the line: there a step makes nothing larger", "Re(h lambda), damping", "Im(h lambda), oscillation",
                false, false, series);
    }

    private static Series boundary(String name, double[] r) {
        int half = 60;
        double[] x = new double[2 * half + 1];
        double[] y = new double[2 * half + 1];
        for (int k = 0; k <= half; k++) {
            double degree = 90 + 90.0 * k / half;
            double reach = reach(r, degree);
            double angle = StrictMath.toRadians(degree);
            x[k] = reach * StrictMath.cos(angle);
            y[k] = reach * StrictMath.sin(angle);
            x[2 * half - k] = x[k];
            y[2 * half - k] = -y[k];
        }
        return new Series(name, Mark.LINE, x, y);
    }
}
