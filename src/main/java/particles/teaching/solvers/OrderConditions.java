package particles.teaching.solvers;

import java.util.Arrays;
import java.util.stream.IntStream;

/** The order of an explicit Runge-Kutta method from its coefficients: the conditions of Butcher up to order 4. */
final class OrderConditions {
    private static final double ROUNDING = 1e-12;
    /** Coefficients that are printed with eight digits, such as Ralston's. */
    private static final double PRINTED = 5e-8;

    private OrderConditions() {
    }

    /**
     * @return the order, 0 to 4; 4 may also be more. Methods whose clocks are not the sums of their rows have order 1
     *         at most
     */
    static int order(Scheme scheme) {
        return order(scheme, PRINTED);
    }

    /** @return whether the conditions hold to all digits */
    static boolean isExact(Scheme scheme) {
        return order(scheme, ROUNDING) == order(scheme, PRINTED);
    }

    private static int order(Scheme scheme, double rounding) {
        int n = scheme.size();
        double[][] a = scheme.stages().stream().map(row -> row.from(1, n)).toArray(double[][]::new);
        double[] b = scheme.ends().get(0).from(1, n);
        double[] c = scheme.times();
        double[] one = new double[n];
        Arrays.fill(one, 1);
        double[] cc = product(c, c);
        double[] ac = times(a, c);
        double[][] left = {{dot(b, one) - 1}, {dot(b, c) - 1.0 / 2, IntStream.range(0, n).mapToDouble(i ->
            Math.abs(dot(a[i], one) - c[i])).max().orElse(0)}, {dot(b, cc) - 1.0 / 3, dot(b, ac) - 1.0 / 6},
            {dot(b, product(cc, c)) - 1.0 / 4, dot(b, product(c, ac)) - 1.0 / 8, dot(b, times(a, cc)) - 1.0 / 12,
                dot(b, times(a, ac)) - 1.0 / 24}};
        int order = 0;
        while (order < left.length && Arrays.stream(left[order]).allMatch(off -> Math.abs(off) <= rounding)) {
            order++;
        }
        return order;
    }

    private static double[] product(double[] x, double[] y) {
        return IntStream.range(0, x.length).mapToDouble(i -> x[i] * y[i]).toArray();
    }

    private static double[] times(double[][] a, double[] x) {
        return Arrays.stream(a).mapToDouble(row -> dot(row, x)).toArray();
    }

    private static double dot(double[] x, double[] y) {
        return IntStream.range(0, x.length).mapToDouble(i -> x[i] * y[i]).sum();
    }
}
