package particles.teaching.solvers;

import java.util.Arrays;

/** The order of an explicit Runge-Kutta method from its coefficients: the conditions of Butcher up to order 4. */
final class OrderConditions {
    private static final double ROUNDING = 1e-12;

    private OrderConditions() {
    }

    /**
     * @param a the rows, strictly lower triangular, in units of deltaT
     * @param b the weights
     * @param c the clocks
     * @return the order, 0 to 4; 4 may also be more. Methods whose clocks are not the sums of their
     *         rows have order 1 at most
     */
    static int order(double[][] a, double[] b, double[] c) {
        int n = b.length;
        double[] one = new double[n];
        Arrays.fill(one, 1);
        if (!is(dot(b, one), 1)) {
            return 0;
        }
        if (!MethodDifferences.same(times(a, one), c) || !is(dot(b, c), 1.0 / 2)) {
            return 1;
        }
        double[] cc = product(c, c);
        double[] ac = times(a, c);
        if (!is(dot(b, cc), 1.0 / 3) || !is(dot(b, ac), 1.0 / 6)) {
            return 2;
        }
        boolean four = is(dot(b, product(cc, c)), 1.0 / 4) && is(dot(b, product(c, ac)), 1.0 / 8)
                && is(dot(b, times(a, cc)), 1.0 / 12) && is(dot(b, times(a, ac)), 1.0 / 24);
        return four ? 4 : 3;
    }

    private static boolean is(double x, double y) {
        return Math.abs(x - y) <= ROUNDING;
    }

    private static double[] product(double[] x, double[] y) {
        double[] product = new double[x.length];
        Arrays.setAll(product, i -> x[i] * y[i]);
        return product;
    }

    private static double[] times(double[][] a, double[] x) {
        double[] product = new double[x.length];
        Arrays.setAll(product, i -> dot(a[i], x));
        return product;
    }

    private static double dot(double[] x, double[] y) {
        double sum = 0;
        for (int i = 0; i < x.length; i++) {
            sum += x[i] * y[i];
        }
        return sum;
    }
}
