package particles.teaching.figures;

import deSolvers.DESolver;
import deSolvers.problems.LinearPair;
import deSolvers.problems.StepMatrix;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import particles.teaching.Formula;

/**
 * The stability function R(z) of a solver, found from its steps as a fraction of two polynomials. A step multiplies the
 * solution of s' = lambda s by R(z), z = deltaT lambda. An explicit Runge-Kutta method has a polynomial, an implicit
 * one a fraction.
 *
 * @param above the coefficients above the line, from z^0 on
 * @param below those below the line; 1 alone for a polynomial
 */
record StabilityFunction(double[] above, double[] below) {
    private static final int PLACES = 16;
    private static final double RADIUS = 0.25;
    /** The number of coefficients used: those of higher powers are lost in round-off. */
    private static final int KNOWN = 9;
    private static final double ROUNDING = 1e-13;
    private static final int[][] DEGREES = {{1, 0}, {0, 1}, {2, 0}, {1, 1}, {3, 0}, {0, 2}, {1, 2}, {2, 1}, {4, 0},
            {2, 2}, {5, 0}, {6, 0}};
    /** Those whose R is the beginning of the exponential series, by its degree. */
    private static final List<String> OWNERS = List.of("", "that of the Euler method",
            "the same for all methods of order 2 with two evaluations, such as midpoint",
            "the same for all methods of order 3 with three evaluations",
            "the same for all methods of order 4 with four evaluations, such as RK4");

    /**
     * @param maker makes solvers whose step treats all entries of the state alike
     * @param noise the residual of an iteration, relative to the state
     * @return the simplest fraction that is R; empty if there is none of degree 2, and no polynomial of degree 6
     */
    static Optional<StabilityFunction> of(Supplier<DESolver> maker, double noise) {
        double[] taylor = taylor(maker);
        return Arrays.stream(DEGREES).flatMap(degree -> fraction(taylor, degree[0], degree[1], ROUNDING + 10 * noise)
                .stream()).findFirst();
    }

    /** By Cauchy's formula on a circle around 0; R of the conjugate is the conjugate of R. */
    private static double[] taylor(Supplier<DESolver> maker) {
        double[] c = new double[KNOWN];
        for (int j = 0; j < PLACES; j++) {
            double angle = 2 * Math.PI * j / PLACES;
            StepMatrix step = StepMatrix.of(maker.get(), LinearPair.testEquation(RADIUS * StrictMath.cos(angle),
                    RADIUS * StrictMath.sin(angle)), 1, 1, 1);
            for (int k = 0; k < KNOWN; k++) {
                double turned = step.xx() * StrictMath.cos(k * angle) + step.vx() * StrictMath.sin(k * angle);
                c[k] += turned / (PLACES * StrictMath.pow(RADIUS, k));
            }
        }
        return c;
    }

    /** The fraction of these degrees that begins as the series does (H. Padé 1892), if it also goes on so. */
    private static Optional<StabilityFunction> fraction(double[] c, int m, int n, double tolerance) {
        double[] q = new double[n + 1];
        q[0] = 1;
        if (n == 1) {
            q[1] = -c[m + 1] / c[m];
        } else if (n == 2) {
            double before = m == 0 ? 0 : c[m - 1];
            double determinant = c[m] * c[m] - before * c[m + 1];
            q[1] = (before * c[m + 2] - c[m] * c[m + 1]) / determinant;
            q[2] = (c[m + 1] * c[m + 1] - c[m] * c[m + 2]) / determinant;
        }
        double[] p = new double[c.length];              // q times the series: nothing is left beyond z^m
        for (int k = 0; k < p.length; k++) {
            for (int j = 0; j <= Math.min(k, n); j++) {
                p[k] += q[j] * c[k - j];
            }
            if (k > m && !(Math.abs(p[k]) * StrictMath.pow(RADIUS, k) <= tolerance)) {
                return Optional.empty();
            }
        }
        return Optional.of(new StabilityFunction(Arrays.copyOf(p, m + 1), q));
    }

    /** @return the formula, such as {@code (1 + z/2) / (1 - z/2)} */
    String text() {
        return below.length == 1 ? polynomial(above) : bracketed(above) + " / " + bracketed(below);
    }

    private static String bracketed(double[] p) {
        return Arrays.stream(p).filter(c -> !Formula.same(c, 0)).count() > 1 ? "(" + polynomial(p) + ")"
                : polynomial(p);
    }

    private static String polynomial(double[] p) {
        List<String> powers = new ArrayList<>(List.of("1", "z"));
        for (int k = 2; k < p.length; k++) {
            powers.add("z^" + k);
        }
        return Formula.sum(p, powers);
    }

    /** @return the method that has this function, such as {@code that of Euler}; empty if it is unknown */
    String owner() {
        double factorial = 1;
        boolean series = below.length == 1 && above.length <= OWNERS.size();
        for (int k = 0; k < above.length; k++) {
            factorial *= Math.max(1, k);
            series &= Formula.same(above[k] * factorial, 1);
        }
        if (series) {
            return OWNERS.get(above.length - 1);
        }
        if (above.length > 2 || below.length != 2 || !Formula.same(above[0], 1) || !Formula.same((above.length == 1 ? 0
                : above[1]) - below[1], 1)) {
            return "";
        }
        return Formula.same(below[1], -1) ? "that of backward Euler" : Formula.same(below[1], -0.5)
                ? "that of the trapezoidal rule and of implicit midpoint" : "that of the theta method with theta = "
                + Formula.number(-below[1]);
    }
}
