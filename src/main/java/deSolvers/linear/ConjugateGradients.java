package deSolvers.linear;

/**
 * Preconditioned conjugate gradients for a symmetric positive definite matrix.
 *
 * <p>Source: M. R. Hestenes, E. Stiefel (1952), J. Res. Nat. Bur. Standards 49, 409.
 */
public final class ConjugateGradients {
    private final ImplicitWork.Counter work;
    private double[] r = {};
    private double[] z = {};
    private double[] p = {};
    private double[] ap = {};

    public ConjugateGradients(ImplicitWork.Counter work) {
        this.work = work;
    }

    /**
     * Solves A x = b until the preconditioned residual is tolerance times its first value.
     *
     * @param x begins as the approximation it holds
     * @return false if the matrix turns out not to be positive definite, or the number of iterations did not suffice
     */
    public boolean solve(LinearOperator a, LinearOperator preconditioner, double[] b, double[] x, double tolerance,
            int mostIterations) {
        int n = b.length;
        if (r.length != n) {
            r = new double[n];
            z = new double[n];
            p = new double[n];
            ap = new double[n];
        }
        a.apply(x, ap);
        for (int i = 0; i < n; i++) {
            r[i] = b[i] - ap[i];
        }
        preconditioner.apply(r, z);
        System.arraycopy(z, 0, p, 0, n);
        double rz = Gmres.dot(r, z);
        double goal = tolerance * tolerance * rz;
        for (int iteration = 0; rz > goal; iteration++) {
            if (iteration == mostIterations) {
                return false;
            }
            work.krylovIterations++;
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
