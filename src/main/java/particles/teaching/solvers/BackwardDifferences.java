package particles.teaching.solvers;

import deSolvers.DESolver;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import particles.teaching.Formula;
import particles.teaching.sources.NonlinearOscillators;

/**
 * The coefficients of a backward differentiation formula, new = a_1 s + a_2 s(one step before) + ... + b deltaT f(new),
 * found by least squares from the states of its steps.
 */
final class BackwardDifferences {
    private static final double[][] RIGHT = {{4.0 / 3, -1.0 / 3, 2.0 / 3}, {18.0 / 11, -9.0 / 11, 2.0 / 11, 6.0 / 11}};
    private static final double H = 1.0 / 8;
    private static final int STEPS = 6;
    /** The iteration leaves about 1e-10. */
    private static final double FITS = 1e-7;
    private static final double SAME = 1e-4;

    private record Formulas(double[] found, double[] right) {
        boolean isRight() {
            return isSame(found, right);
        }
    }

    private BackwardDifferences() {
    }

    /** @return the mistake in the coefficients; empty if there is none, or it is no such formula */
    static Optional<String> wrong(Supplier<DESolver> maker) {
        return read(maker).filter(formula -> !formula.isRight()).map(formula -> "the new state solves new = "
                + text(formula.found) + "; the formula of order " + (formula.right.length - 1) + " is new = "
                + text(formula.right));
    }

    /** @return whether its steps solve the equation of such a formula */
    static boolean isRight(Supplier<DESolver> maker) {
        return read(maker).filter(Formulas::isRight).isPresent();
    }

    private static Optional<Formulas> read(Supplier<DESolver> maker) {
        List<double[]> states = new ArrayList<>();
        NonlinearOscillators source = new NonlinearOscillators(3);
        DESolver solver = maker.get();
        try {
            for (int step = 0; step < STEPS; step++) {
                states.add(0, source.state());
                solver.stepState(source, H);
            }
        } catch (RuntimeException e) {
            return Optional.empty();
        }
        double[] next = source.state();
        double[] slope = new double[next.length];
        source.getStateDerivative(slope);
        for (double[] right : RIGHT) {
            int n = right.length;
            double[][] columns = new double[n][];
            for (int j = 0; j < n - 1; j++) {
                columns[j] = states.get(j);
            }
            columns[n - 1] = Arrays.stream(slope).map(x -> H * x).toArray();
            double[] found = leastSquares(columns, next);
            if (misfit(columns, found, next) < FITS) {
                return Optional.of(new Formulas(found, right));
            }
        }
        return Optional.empty();
    }

    private static boolean isSame(double[] found, double[] right) {
        for (int j = 0; j < found.length; j++) {
            if (Math.abs(found[j] - right[j]) > SAME) {
                return false;
            }
        }
        return true;
    }

    private static String text(double[] c) {
        List<String> names = List.of("s(n)", "s(n-1)", "s(n-2)").subList(0, c.length - 1);
        List<String> all = new ArrayList<>(names);
        all.add("deltaT f(new)");
        double[] shown = Arrays.stream(c).map(x -> Math.rint(x * 66) / 66).toArray();
        return Formula.state(0, isSame(c, shown) ? shown : c, all).strip();
    }

    private static double misfit(double[][] columns, double[] c, double[] expected) {
        double largest = 0;
        for (int k = 0; k < expected.length; k++) {
            double sum = -expected[k];
            for (int j = 0; j < c.length; j++) {
                sum += c[j] * columns[j][k];
            }
            largest = Math.max(largest, Math.abs(sum));
        }
        return largest;
    }

    /** By orthogonal columns (modified Gram-Schmidt), which keep the digits that normal equations lose. */
    private static double[] leastSquares(double[][] columns, double[] expected) {
        int n = columns.length;
        double[][] q = new double[n][];
        double[][] r = new double[n][n];
        double[] right = new double[n];
        for (int j = 0; j < n; j++) {
            q[j] = columns[j].clone();
            for (int i = 0; i < j; i++) {
                r[i][j] = dot(q[i], q[j]);
                subtract(q[j], r[i][j], q[i]);
            }
            r[j][j] = Math.sqrt(dot(q[j], q[j]));
            double length = r[j][j];
            q[j] = Arrays.stream(q[j]).map(x -> x / length).toArray();
            right[j] = dot(q[j], expected);
        }
        for (int j = n - 1; j >= 0; j--) {
            for (int k = j + 1; k < n; k++) {
                right[j] -= r[j][k] * right[k];
            }
            right[j] /= r[j][j];
        }
        return right;
    }

    private static double dot(double[] x, double[] y) {
        double sum = 0;
        for (int k = 0; k < x.length; k++) {
            sum += x[k] * y[k];
        }
        return sum;
    }

    private static void subtract(double[] from, double factor, double[] x) {
        for (int k = 0; k < from.length; k++) {
            from[k] -= factor * x[k];
        }
    }
}
