package deSolvers.linear;

import java.util.Arrays;

/**
 * Preconditioned conjugate gradients for a symmetric positive definite matrix.
 *
 * <p>Source: M. R. Hestenes, E. Stiefel (1952), J. Res. Nat. Bur. Standards 49, 409.
 */
final class ConjugateGradients {
    private static final int MOST_ITERATIONS = 5000;

    private final SolverWork work;
    private double[] r = {};
    private double[] z = {};
    private double[] p = {};
    private double[] ap = {};

    ConjugateGradients(SolverWork work) {
        this.work = work;
    }

    /**
     * Solves A x = b, beginning at x = 0, until the preconditioned residual is tolerance times its first value.
     *
     * @return false if the matrix turns out not to be positive definite, or the number of iterations did not suffice
     */
    boolean solve(LinearOperator a, LinearOperator preconditioner, double[] b, double[] x, double tolerance) {
        int n = b.length;
        if (r.length != n) {
            r = new double[n];
            z = new double[n];
            p = new double[n];
            ap = new double[n];
        }
        Arrays.fill(x, 0);
        System.arraycopy(b, 0, r, 0, n);
        preconditioner.apply(r, z);
        System.arraycopy(z, 0, p, 0, n);
        double rz = Gmres.dot(r, z);
        double goal = tolerance * tolerance * rz;
        for (int iteration = 0; rz > goal; iteration++) {
            if (iteration == MOST_ITERATIONS) {
                return false;
            }
            work.iterations++;
            a.apply(p, ap);
            double curvature = Gmres.dot(p, ap);
            if (!(curvature > 0)) {
                return false;
            }
            double alpha = rz / curvature;
            for (int i = 0; i < n; i++) {
                x[i] += alpha * p[i];
                r[i] -= alpha * ap[i];
            }
            preconditioner.apply(r, z);
            double rzNext = Gmres.dot(r, z);
            double beta = rzNext / rz;
            for (int i = 0; i < n; i++) {
                p[i] = z[i] + beta * p[i];
            }
            rz = rzNext;
        }
        return rz >= 0;
    }
}
