package particles.teaching.collection;

import static particles.teaching.solvers.PlantedSolvers.slope;
import static particles.teaching.solvers.PlantedSolvers.slopeAt;
import static particles.teaching.solvers.PlantedSolvers.state;

import deSolvers.DESolver;
import deSolvers.DEStateSource;
import deSolvers.SecondOrderStateSource;
import java.util.Arrays;
import java.util.function.UnaryOperator;
import particles.teaching.solvers.PlantedSolvers.Step;

/** What several solvers of the collection are made of. */
final class Pieces {
    private static final double DIFFERENCE = 1e-7;

    private Pieces() {
    }

    static double[] plus(double[] s, double factor, double[] k) {
        double[] sum = new double[s.length];
        for (int i = 0; i < s.length; i++) {
            sum[i] = s[i] + factor * k[i];
        }
        return sum;
    }

    static double norm(double[] s) {
        double largest = 0;
        for (double x : s) {
            largest = Math.max(largest, Math.abs(x));
        }
        return largest;
    }

    private static double[] numbers(String row) {
        return Arrays.stream(row.strip().split("\\s+")).filter(word -> !word.isEmpty()).mapToDouble(word -> {
            String[] parts = word.split("/");
            return Double.parseDouble(parts[0]) / (parts.length == 1 ? 1 : Double.parseDouble(parts[1]));
        }).toArray();
    }

    /**
     * The rows from the second stage on, separated by semicolons; weights; times of the stages, or "" for the rows'
     * sums.
     */
    static Step rungeKutta(String rows, String weights, String times) {
        String[] lines = rows.isBlank() ? new String[0] : rows.split(";");
        double[][] a = new double[lines.length + 1][];
        a[0] = new double[0];
        for (int i = 0; i < lines.length; i++) {
            a[i + 1] = numbers(lines[i]);
        }
        double[] b = numbers(weights);
        double[] c = times.isEmpty() ? Arrays.stream(a).mapToDouble(row -> Arrays.stream(row).sum()).toArray()
                : numbers(times);
        return (source, deltaT) -> {
            double start = source.getTime();
            double[] s = state(source);
            double[][] k = new double[a.length][];
            double[] next = s;
            for (int i = 0; i < a.length; i++) {
                double[] trial = s;
                for (int j = 0; j < a[i].length; j++) {
                    trial = plus(trial, deltaT * a[i][j], k[j]);
                }
                source.incTime(start + c[i] * deltaT - source.getTime());
                k[i] = slopeAt(source, trial);
                next = plus(next, deltaT * b[i], k[i]);
            }
            source.setState(next);
            source.incTime(start + deltaT - source.getTime());
        };
    }

    /** Newton's iteration with differences for the Jacobian, until a change is below the tolerance. */
    static double[] newton(UnaryOperator<double[]> residual, double[] guess, double tolerance, int most) {
        double[] s = guess.clone();
        for (int iteration = 0; iteration < most; iteration++) {
            double[] r = residual.apply(s);
            double[][] matrix = new double[s.length][s.length + 1];
            for (int j = 0; j < s.length; j++) {
                double[] moved = s.clone();
                moved[j] += DIFFERENCE;
                double[] there = residual.apply(moved);
                for (int i = 0; i < s.length; i++) {
                    matrix[i][j] = (there[i] - r[i]) / DIFFERENCE;
                }
            }
            for (int i = 0; i < s.length; i++) {
                matrix[i][s.length] = -r[i];
            }
            double[] change = eliminate(matrix);
            s = plus(s, 1, change);
            if (norm(change) < tolerance) {
                break;
            }
        }
        return s;
    }

    static double[] eliminate(double[][] m) {
        int n = m.length;
        for (int p = 0; p < n; p++) {
            int best = p;
            for (int i = p + 1; i < n; i++) {
                best = Math.abs(m[i][p]) > Math.abs(m[best][p]) ? i : best;
            }
            double[] row = m[best];
            m[best] = m[p];
            m[p] = row;
            for (int i = p + 1; i < n; i++) {
                double factor = m[i][p] / row[p];
                for (int j = p; factor != 0 && j <= n; j++) {
                    m[i][j] -= factor * row[j];
                }
            }
        }
        double[] x = new double[n];
        for (int i = n - 1; i >= 0; i--) {
            double sum = m[i][n];
            for (int j = i + 1; j < n; j++) {
                sum -= m[i][j] * x[j];
            }
            x[i] = sum / m[i][i];
        }
        return x;
    }

    /**
     * A method whose new state solves new = s + deltaT (now f(s, t) + end f(s + place (new - s), t + clock deltaT)).
     *
     * @param tolerance of Newton's iteration
     * @param most      iterations at most
     */
    static Step implicit(double now, double end, double place, double clock, double tolerance, int most) {
        return (source, deltaT) -> {
            double t = source.getTime();
            double[] s = state(source);
            double[] first = slope(source);
            source.incTime(clock * deltaT);
            double[] next = newton(u -> {
                double[] f = slopeAt(source, plus(plus(s, -place, s), place, u));
                return plus(plus(plus(u, -1, s), -deltaT * now, first), -deltaT * end, f);
            }, plus(s, deltaT, first), tolerance, most);
            source.setState(next);
            source.incTime(t + deltaT - source.getTime());
        };
    }

    /** The same by simple iteration. */
    static Step iterated(double now, double end, double place, double clock, double tolerance, int most) {
        return (source, deltaT) -> {
            double t = source.getTime();
            double[] s = state(source);
            double[] first = slope(source);
            source.incTime(clock * deltaT);
            double[] next = plus(s, deltaT, first);
            for (int iteration = 0; iteration < most; iteration++) {
                double[] f = slopeAt(source, plus(plus(s, -place, s), place, next));
                double[] better = plus(plus(s, deltaT * now, first), deltaT * end, f);
                double change = norm(plus(better, -1, next));
                next = better;
                if (change < tolerance) {
                    break;
                }
            }
            source.setState(next);
            source.incTime(t + deltaT - source.getTime());
        };
    }

    /** Moves x by factor * v * h in blocks of positions and velocities. */
    static void drift(DEStateSource source, double[] s, double h) {
        int d = source instanceof SecondOrderStateSource second ? second.getDimension() : 3;
        for (int block = 0; block < s.length; block += 2 * d) {
            for (int i = block; i < block + d; i++) {
                s[i] += h * s[i + d];
            }
        }
        source.setState(s);
        source.incTime(h);
    }

    static void kick(DEStateSource source, double[] s, double h) {
        int d = source instanceof SecondOrderStateSource second ? second.getDimension() : 3;
        double[] dSdt = slope(source);
        for (int block = 0; block < s.length; block += 2 * d) {
            for (int i = block + d; i < block + 2 * d; i++) {
                s[i] += h * dSdt[i];
            }
        }
        source.setState(s);
    }

    /** Drifts and kicks in turn, beginning with a drift; a drift or a kick of 0 is left out. */
    static Step drifts(double[] drifts, double[] kicks) {
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

    static void leapfrog(DEStateSource source, double h) {
        double[] s = state(source);
        kick(source, s, h / 2);
        drift(source, s, h);
        kick(source, s, h / 2);
    }

    /** An embedded pair with a step of its own inside of deltaT. */
    static final class Adaptive extends DESolver {
        private final double[][] a;
        private final double[] b;
        private final double[] error;
        private final double[] c;
        private final double tolerance;
        private final int order;
        private final boolean stopsAtNaN;

        Adaptive(String rows, String weights, String others, double tolerance, int order, boolean stopsAtNaN) {
            String[] lines = rows.split(";");
            a = new double[lines.length + 1][];
            a[0] = new double[0];
            for (int i = 0; i < lines.length; i++) {
                a[i + 1] = numbers(lines[i]);
            }
            b = numbers(weights);
            error = plus(b, -1, numbers(others));
            c = Arrays.stream(a).mapToDouble(row -> Arrays.stream(row).sum()).toArray();
            this.tolerance = tolerance;
            this.order = order;
            this.stopsAtNaN = stopsAtNaN;
        }

        @Override
        public void stepState(DEStateSource source, double deltaT) {
            double end = source.getTime() + deltaT;
            double h = deltaT;
            double done = 0;
            while (Math.abs(done) < Math.abs(deltaT)) {
                h = Math.abs(h) > Math.abs(deltaT - done) ? deltaT - done : h;
                double start = end - deltaT + done;
                double[] s = state(source);
                double[] next = s;
                double[] off = new double[s.length];
                double[][] k = new double[a.length][];
                for (int i = 0; i < a.length; i++) {
                    double[] trial = s;
                    for (int j = 0; j < a[i].length; j++) {
                        trial = plus(trial, h * a[i][j], k[j]);
                    }
                    source.incTime(start + c[i] * h - source.getTime());
                    k[i] = slopeAt(source, trial);
                    next = plus(next, h * b[i], k[i]);
                    off = plus(off, h * error[i], k[i]);
                }
                double size = norm(off) / (tolerance * (1 + norm(s)));
                if (stopsAtNaN && Double.isNaN(Arrays.stream(off).sum())) {
                    throw new ArithmeticException("the derivative is NaN");
                }
                boolean good = stopsAtNaN ? size <= 1 : size <= 1 && !Double.isNaN(Arrays.stream(off).sum());
                source.setState(good ? next : s);
                done += good ? h : 0;
                source.incTime(end - deltaT + done - source.getTime());
                h *= Math.max(0.2, Math.min(5, 0.9 * Math.pow(Math.max(size, 1e-10), -1.0 / order)));
            }
            source.incTime(end - source.getTime());
        }
    }
}
