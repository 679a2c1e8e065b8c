package particles.teaching.collection;

import static particles.teaching.solvers.PlantedSolvers.slope;
import static particles.teaching.solvers.PlantedSolvers.slopeAt;
import static particles.teaching.solvers.PlantedSolvers.state;

import deSolvers.DEStateSource;
import deSolvers.SecondOrderStateSource;
import java.util.Arrays;
import java.util.List;
import java.util.function.UnaryOperator;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import particles.teaching.collection.Changes.Edit;
import particles.teaching.solvers.PlantedSolvers.Step;

/** The kinds of methods of which the solvers of the table are made. */
final class Methods {
    private static final double DIFFERENCE = 1e-7;

    private Methods() {
    }

    static double[] plus(double[] s, double factor, double[] k) {
        double[] sum = new double[s.length];
        Arrays.setAll(sum, i -> s[i] + factor * k[i]);
        return sum;
    }

    static double norm(double[] s) {
        return Arrays.stream(s).map(Math::abs).reduce(0, Math::max);
    }

    static void clock(DEStateSource source, double t) {
        source.incTime(t - source.getTime());
    }

    static double[] sums(double[][] a) {
        return Arrays.stream(a).mapToDouble(row -> Arrays.stream(row).sum()).toArray();
    }

    /** The state s + h (a1 k1 + a2 k2 ...). */
    static double[] trial(double[] s, double h, double[] a, double[][] k) {
        double[] trial = s;
        for (int j = 0; j < a.length; j++) {
            trial = a[j] == 0 ? trial : plus(trial, h * a[j], k[j]);
        }
        return trial;
    }

    /** Explicit, with rows shorter than their number; states are edited before they are set. */
    static Step rungeKutta(double[][] a, double[] b, double[] times, Edit edit) {
        double[] c = times.length > 0 ? times : sums(a);
        return (source, h) -> {
            double t = source.getTime();
            double[] s = state(source);
            double[][] k = new double[a.length][];
            for (int i = 0; i < a.length; i++) {
                clock(source, t + c[i] * h);
                Changes.set(source, edit.of(i, s, trial(s, h, a[i], k)));
                k[i] = slope(source);
            }
            Changes.set(source, edit.of(-1, s, trial(s, h, b, k)));
            clock(source, t + h);
        };
    }

    /** The derivatives of all stages are solved for at once. */
    static Step implicit(double[][] a, double[] b, double[] times, List<String> iteration) {
        double[] c = times.length > 0 ? times : sums(a);
        double tolerance = Double.parseDouble(iteration.get(1));
        int most = Integer.parseInt(iteration.get(2));
        return (source, h) -> {
            double t = source.getTime();
            double[] s = state(source);
            int n = s.length;
            double[] first = new double[n * a.length];
            double[] f = slope(source);
            Arrays.setAll(first, i -> f[i % n]);
            UnaryOperator<double[]> better = all -> {
                double[] next = new double[all.length];
                double[][] k = split(all, n);
                for (int i = 0; i < a.length; i++) {
                    clock(source, t + c[i] * h);
                    System.arraycopy(slopeAt(source, trial(s, h, a[i], k)), 0, next, i * n, n);
                }
                return next;
            };
            double[] all = iteration.get(0).equals("simple") ? simple(better, first, iteration.size() > 3
                    ? h : Math.abs(h), tolerance, most)
                    : newton(u -> plus(u, -1, better.apply(u)), first, tolerance, most);
            source.setState(trial(s, h, b, split(all, n)));
            clock(source, t + h);
        };
    }

    private static double[][] split(double[] all, int n) {
        double[][] parts = new double[all.length / n][];
        Arrays.setAll(parts, i -> Arrays.copyOfRange(all, i * n, i * n + n));
        return parts;
    }

    private static double[] simple(UnaryOperator<double[]> better, double[] first, double h, double tolerance,
            int most) {
        double[] all = first;
        double change = 1;
        for (int round = 0; round < most && !(h * change < tolerance); round++) {
            double[] next = better.apply(all);
            change = norm(plus(next, -1, all));
            all = next;
        }
        return all;
    }

    /** Newton's iteration with differences for the Jacobian, until a change is below the tolerance. */
    static double[] newton(UnaryOperator<double[]> residual, double[] guess, double tolerance, int most) {
        double[] s = guess.clone();
        double size = 1;
        for (int iteration = 0; iteration < most && !(size < tolerance); iteration++) {
            double[] r = residual.apply(s);
            double[] change = solve(jacobian(residual, s, r), plus(new double[s.length], -1, r));
            s = plus(s, 1, change);
            size = norm(change);
        }
        return s;
    }

    static double[][] jacobian(UnaryOperator<double[]> f, double[] s, double[] here) {
        double[][] matrix = new double[s.length][s.length];
        for (int j = 0; j < s.length; j++) {
            double[] moved = s.clone();
            moved[j] += DIFFERENCE;
            double[] there = f.apply(moved);
            for (int i = 0; i < s.length; i++) {
                matrix[i][j] = (there[i] - here[i]) / DIFFERENCE;
            }
        }
        return matrix;
    }

    static double[] solve(double[][] matrix, double[] right) {
        DMatrixRMaj x = new DMatrixRMaj(right.length, 1);
        CommonOps_DDRM.solve(new DMatrixRMaj(matrix), DMatrixRMaj.wrap(right.length, 1, right), x);
        return x.data;
    }

    private static int dimension(DEStateSource source) {
        return source instanceof SecondOrderStateSource second ? second.getDimension() : 3;
    }

    /** Moves x by factor * v * h in blocks of positions and velocities. */
    static void drift(DEStateSource source, double[] s, double h) {
        int d = dimension(source);
        for (int i = 0; i < s.length; i++) {
            s[i] += i / d % 2 == 0 ? h * s[i + d] : 0;
        }
        source.setState(s);
        source.incTime(h);
    }

    static void kick(DEStateSource source, double[] s, double h) {
        int d = dimension(source);
        double[] dSdt = slope(source);
        for (int i = 0; i < s.length; i++) {
            s[i] += i / d % 2 == 1 ? h * dSdt[i] : 0;
        }
        source.setState(s);
    }

    /** A drift or a kick of 0 is left out. */
    static Step turns(double[] drifts, double[] kicks) {
        return (source, deltaT) -> {
            double[] s = state(source);
            for (int i = 0; i < drifts.length; i++) {
                drift(source, s, drifts[i] * deltaT);
                if (i < kicks.length && kicks[i] != 0) {
                    kick(source, s, kicks[i] * deltaT);
                }
            }
        };
    }

    /** New positions x + h v + h^2 (x1 a1 + ...), new velocities v + h (v1 a1 + ...); the trial velocities are old. */
    static Step nystrom(double[][] a, double[] x, double[] v, double[] times) {
        return (source, h) -> {
            int d = dimension(source);
            double t = source.getTime();
            double[] s = state(source);
            double[][] k = new double[times.length][];
            for (int i = 0; i <= times.length; i++) {
                double c = i < times.length ? times[i] : 1;
                double[] row = i < times.length ? a[i] : x;
                double[] next = s.clone();
                for (int e = 0; e < s.length; e++) {
                    boolean position = e / d % 2 == 0;
                    next[e] += position ? c * h * s[e + d] : 0;
                    for (int j = 0; j < i; j++) {
                        next[e] += position ? h * h * (j < row.length ? row[j] : 0) * k[j][e + d]
                                : i < times.length ? 0 : h * v[j] * k[j][e];
                    }
                }
                clock(source, t + c * h);
                source.setState(next);
                if (i < times.length) {
                    k[i] = slope(source);
                }
            }
        };
    }
}
