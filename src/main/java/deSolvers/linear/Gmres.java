package deSolvers.linear;

import java.util.Arrays;

/**
 * GMRES with restarts and right preconditioning, for matrices that need not be symmetric or definite.
 *
 * <p>Source: Y. Saad, M. H. Schultz (1986), SIAM J. Sci. Stat. Comput. 7, 856.
 */
public final class Gmres {
    private static final int RESTART = 40;
    private static final int MOST_ITERATIONS = 2000;
    /** A remainder of at most this part of a vector is round-off. */
    private static final double ROUNDING = 1e-14;

    private final SolverWork work;
    private double[][] basis = new double[RESTART + 1][0];
    private double[] image = {};
    private double[] preconditioned = {};
    private final double[][] hessenberg = new double[RESTART + 1][RESTART];
    private final double[] cosine = new double[RESTART];
    private final double[] sine = new double[RESTART];
    private final double[] right = new double[RESTART + 1];
    private final double[] y = new double[RESTART];

    /** @param work counts the iterations */
    Gmres(SolverWork work) {
        this.work = work;
    }

    /**
     * Solves A x = b, beginning at x = 0.
     *
     * @param a              A
     * @param preconditioner approximates the inverse of A
     * @param b              the right-hand side
     * @param x              receives the solution
     * @param tolerance      stops at a residual of this times |b|
     * @return false if that was not reached in {@value #MOST_ITERATIONS} iterations, or if a restart gained almost
     *         nothing
     */
    boolean solve(LinearOperator a, LinearOperator preconditioner, double[] b, double[] x, double tolerance) {
        int n = b.length;
        if (image.length != n) {
            basis = new double[RESTART + 1][0];
            image = new double[n];
            preconditioned = new double[n];
        }
        Arrays.fill(x, 0);
        System.arraycopy(b, 0, vector(0, n), 0, n);
        double goal = tolerance * norm(b);
        double last = Double.POSITIVE_INFINITY;         // the residual before the last restart
        int iterations = 0;
        while (goal <= Double.MAX_VALUE) {
            double beta = norm(basis[0]);
            if (!(beta > goal) || iterations >= MOST_ITERATIONS || beta > 0.9 * last) {
                return beta <= goal;                    // a restart that gains less than a tenth goes nowhere
            }
            last = beta;
            scale(basis[0], 1 / beta);
            Arrays.fill(right, 0);
            right[0] = beta;
            int k = 0;
            while (k < RESTART && iterations < MOST_ITERATIONS && Math.abs(right[k]) > goal / 2) {
                iterations++;
                work.iterations++;
                preconditioner.apply(basis[k], preconditioned);
                double[] next = vector(k + 1, n);
                a.apply(preconditioned, next);
                orthogonalise(next, k);
                k++;
                if (!(hessenberg[k][k - 1] > 0)) {
                    break;                              // the Krylov space is exhausted
                }
            }
            addCombination(x, k, preconditioner);
            if (Math.abs(right[k]) <= goal) {
                return true;
            }
            a.apply(x, image);
            for (int i = 0; i < n; i++) {
                basis[0][i] = b[i] - image[i];
            }
        }
        return false;
    }

    /** Modified Gram-Schmidt, then the Givens rotation that keeps the Hessenberg matrix triangular. */
    private void orthogonalise(double[] next, int k) {
        double square = dot(next, next);
        for (int i = 0; i <= k; i++) {
            double h = dot(next, basis[i]);
            hessenberg[i][k] = h;
            for (int c = 0; c < next.length; c++) {
                next[c] -= h * basis[i][c];
            }
        }
        double length = norm(next);
        if (length > 0) {
            scale(next, 1 / length);
        }
        for (int i = 0; i < k; i++) {
            double upper = hessenberg[i][k];
            hessenberg[i][k] = cosine[i] * upper + sine[i] * hessenberg[i + 1][k];
            hessenberg[i + 1][k] = -sine[i] * upper + cosine[i] * hessenberg[i + 1][k];
        }
        double radius = Math.sqrt(hessenberg[k][k] * hessenberg[k][k] + length * length);
        boolean lost = radius <= ROUNDING * Math.sqrt(square);  // A is singular there: this vector takes nothing away
        cosine[k] = lost ? 0 : hessenberg[k][k] / radius;
        sine[k] = lost ? 1 : length / radius;
        hessenberg[k][k] = lost ? 0 : radius;
        hessenberg[k + 1][k] = lost ? 0 : length;
        right[k + 1] = -sine[k] * right[k];
        right[k] *= cosine[k];
    }

    private void addCombination(double[] x, int k, LinearOperator preconditioner) {
        for (int i = k - 1; i >= 0; i--) {
            double sum = right[i];
            for (int j = i + 1; j < k; j++) {
                sum -= hessenberg[i][j] * y[j];
            }
            y[i] = hessenberg[i][i] == 0 ? 0 : sum / hessenberg[i][i];
        }
        Arrays.fill(image, 0);
        for (int j = 0; j < k; j++) {
            for (int i = 0; i < x.length; i++) {
                image[i] += y[j] * basis[j][i];
            }
        }
        preconditioner.apply(image, preconditioned);
        for (int i = 0; i < x.length; i++) {
            x[i] += preconditioned[i];
        }
    }

    private double[] vector(int k, int n) {
        if (basis[k].length != n) {
            basis[k] = new double[n];
        }
        return basis[k];
    }

    /** @return the scalar product of two vectors */
    public static double dot(double[] a, double[] b) {
        double sum = 0;
        for (int i = 0; i < a.length; i++) {
            sum += a[i] * b[i];
        }
        return sum;
    }

    /**
     * @param a a vector
     * @return its Euclidean length
     */
    public static double norm(double[] a) {
        return Math.sqrt(dot(a, a));
    }

    private static void scale(double[] a, double factor) {
        for (int i = 0; i < a.length; i++) {
            a[i] *= factor;
        }
    }
}
