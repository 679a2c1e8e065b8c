package particles.reactions.algebra;

import java.util.Arrays;

/**
 * Active-set solver of a mixed linear complementarity problem: A lambda - b = w with w = 0 in the rows of rods and
 * wires, and lambda &ge; 0, w &ge; 0, lambda w = 0 in those of contacts: a contact either pushes or separates. The
 * active contacts are found by principal pivoting with the least index first, starting with all (K. Murty 1974); each
 * set takes one linear system. If A is positive definite the search always ends.
 */
public final class ActiveSetMethod {
    private static final double ROUNDING = 1e-10;

    private final MinimumNormSolution system = new MinimumNormSolution();
    private boolean[] active = {};
    private double[] work = {};
    private double left;

    /** The largest residual entry, above round-off if rows contradict each other. */
    public double left() {
        return left;
    }

    /**
     * Solves the problem.
     *
     * @param n       the number of rows
     * @param free    the number of rows of rods and wires, which come first
     * @param a       A by rows
     * @param b       b
     * @param signed  whether contacts can only push; if false, all of them hold unless they determine each other
     * @param lambda  receives the solution
     * @return false if the search does not end: no forces satisfy all conditions
     */
    public boolean solve(int n, int free, double[] a, double[] b, boolean signed, double[] lambda) {
        if (active.length < n) {
            active = new boolean[n];
            work = new double[n];
        }
        Arrays.fill(active, 0, n, true);
        for (int pivots = 0; pivots <= 50 + 20 * (n - free); pivots++) {
            solveActive(n, a, b, lambda);
            if (!signed && pivots == 0 && !system.isSingular()) {
                return true;
            }
            int wrong = firstWrong(n, free, a, b, lambda);
            if (wrong < 0) {
                return true;
            }
            active[wrong] = !active[wrong];
        }
        return false;
    }

    private void solveActive(int n, double[] a, double[] b, double[] lambda) {
        int m = 0;
        for (int r = 0; r < n; r++) {
            m += active[r] ? 1 : 0;
        }
        system.begin(m);
        int row = 0;
        for (int r = 0; r < n; r++) {
            if (active[r]) {
                int column = 0;
                for (int c = 0; c < n; c++) {
                    if (active[c]) {
                        system.set(row, column++, a[r * n + c]);
                    }
                }
                work[row++] = b[r];
            }
        }
        left = 0;
        if (m > 0) {
            system.factorise();
            left = system.solve(work);
        }
        row = 0;
        for (int r = 0; r < n; r++) {
            lambda[r] = active[r] ? work[row++] : 0;
        }
    }

    private int firstWrong(int n, int free, double[] a, double[] b, double[] lambda) {
        double force = 0;
        double motion = 0;
        for (int r = 0; r < n; r++) {
            force = Math.max(force, Math.abs(lambda[r]));
            motion = Math.max(motion, Math.abs(b[r]));
        }
        for (int r = free; r < n; r++) {
            if (active[r]) {
                if (lambda[r] < -ROUNDING * force) {
                    return r;
                }
            } else {
                double w = -b[r];
                for (int c = 0; c < n; c++) {
                    w += a[r * n + c] * lambda[c];
                }
                if (w < -ROUNDING * motion) {
                    return r;
                }
            }
        }
        return -1;
    }
}
