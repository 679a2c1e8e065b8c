package deSolvers.linear;

import java.util.Arrays;

/**
 * A sparse linear solver: A x = b for a matrix of 3 x 3 blocks. A small or ill-conditioned matrix is factorised;
 * otherwise conjugate gradients solve a symmetric positive definite system, and GMRES any other, both preconditioned by
 * the diagonal blocks.
 *
 * <p>Conjugate gradients need a number of iterations proportional to the square root of the condition number; a
 * factorisation always needs the same work. The matrix is factorised if iterations are expected to take more work, or
 * did so for earlier right-hand sides. Factors of an earlier matrix serve as the preconditioner of GMRES until they
 * cost many more iterations than when they were new.
 */
public final class BlockSolver {
    /** Up to this number of rows the matrix is always factorised. */
    private static final int SMALL = 64;
    /**
     * Conjugate gradients need about this number times the square root of the condition number of iterations for four
     * digits.
     */
    private static final double ITERATIONS = 2.6;
    /** GMRES, which restarts, needs about this many times more. */
    private static final double BY_GMRES = 2;
    /** Up to this number of expected iterations no factorisation is considered. */
    private static final double FEW_ITERATIONS = 15;
    /** Factors are old when a solution takes this many iterations more than with new ones. */
    private static final long MOST_MORE = 30;

    private final SolverWork work;
    private final BlockJacobi blockJacobi;
    private final ConjugateGradients conjugateGradients;
    private final Gmres gmres;
    private final Gmres complexGmres;
    private final LinearOperator inverse = this::applyInverse;
    private final LinearOperator complexInverse = this::applyComplexInverse;
    private double[] half = {};
    private double[] image = {};
    private BlockMatrix matrix;
    private LinearOperator operator;
    private BlockFactors factors;                       // null until a matrix of this pattern may need them
    private boolean factorised;                         // whether they are those of this matrix or an earlier one
    private boolean current;                            // whether they are those of this matrix
    private boolean symmetric;
    private long fewest;                                // iterations of a solution with these factors
    private long most;
    private double spent;                               // iterations of this matrix; complex ones count as two

    /** @param work counts the operations */
    public BlockSolver(SolverWork work) {
        this.work = work;
        blockJacobi = new BlockJacobi(work);
        conjugateGradients = new ConjugateGradients(work);
        gmres = new Gmres(work);
        complexGmres = new Gmres(work);
    }

    /** Forgets the factors of earlier matrices. */
    public void forget() {
        factorised = false;
    }

    /**
     * Takes a matrix.
     *
     * @param matrix    A, or an approximation from which the preconditioner is made
     * @param operator  A
     * @param condition an estimate of the condition number of A after scaling by its diagonal blocks
     * @return false if it is found to be singular
     */
    public boolean prepare(BlockMatrix matrix, LinearOperator operator, double condition) {
        if (this.matrix == null || this.matrix.getPattern() != matrix.getPattern()) {
            factors = null;
            factorised = false;
        }
        this.matrix = matrix;
        this.operator = operator;
        current = false;
        spent = 0;
        symmetric = matrix.isSymmetric();
        boolean direct = matrix.getPattern().rows <= SMALL || iterationsCostMore(expected(condition));
        if (direct && factorised && most <= fewest + MOST_MORE) {
            return true;
        }
        factorised = false;
        return direct && factorise() || blockJacobi.prepare(matrix);
    }

    private double expected(double condition) {
        return (symmetric ? 1 : BY_GMRES) * ITERATIONS * Math.sqrt(condition);
    }

    private boolean iterationsCostMore(double expected) {
        if (expected <= FEW_ITERATIONS || !factors().isFit()) {
            return false;
        }
        BlockPattern pattern = matrix.getPattern();
        return factors.products(symmetric) + factors.blocks() < expected * (pattern.countBlocks() + pattern.rows);
    }

    private BlockFactors factors() {
        factors = factors == null ? new BlockFactors(matrix.getPattern(), work) : factors;
        return factors;
    }

    private boolean factorise() {
        factorised = factors().isFit() && factors.factorise(matrix, symmetric);
        current = factorised;
        fewest = Long.MAX_VALUE / 2;
        most = 0;
        return factorised;
    }

    /**
     * Solves A x = b.
     *
     * @param tolerance iterations stop at |b - A x| &lt;= tolerance |b|
     * @return false if the matrix is singular or the iterations did not converge
     */
    public boolean solve(double[] b, double[] x, double tolerance) {
        boolean direct = factorised || iterationsCostMore(spent) && factorise();
        long before = work.iterations;
        boolean solved = !direct && symmetric && operator == matrix
                && conjugateGradients.solve(matrix, blockJacobi, b, x, tolerance);
        spent += work.iterations - before;
        return solved || solve(gmres, operator, inverse, b, x, tolerance)
                || !current && factorise() && solve(gmres, operator, factors, b, x, tolerance);
    }

    /**
     * Solves a complex system, preconditioned as the real one is.
     *
     * @param operator  the complex matrix, for vectors of all real parts and then all imaginary parts
     * @param b         the right-hand side; all real parts, then all imaginary parts
     * @param x         receives the solution
     * @param tolerance iterations stop at |b - A x| &lt;= tolerance |b|
     * @return false if the iterations did not converge
     */
    public boolean solveComplex(LinearOperator operator, double[] b, double[] x, double tolerance) {
        return solve(complexGmres, operator, complexInverse, b, x, tolerance);
    }

    private boolean solve(Gmres gmres, LinearOperator operator, LinearOperator preconditioner, double[] b, double[] x,
                          double tolerance) {
        long before = work.iterations;
        boolean solved = gmres.solve(operator, preconditioner, b, x, tolerance);
        fewest = Math.min(fewest, work.iterations - before);
        most = solved ? Math.max(most, work.iterations - before) : Long.MAX_VALUE;
        spent += (double) (work.iterations - before) * b.length / (3 * matrix.getPattern().rows);
        return solved;
    }

    private void applyInverse(double[] x, double[] y) {
        (factorised ? factors : blockJacobi).apply(x, y);
    }

    private void applyComplexInverse(double[] x, double[] y) {
        int n = x.length / 2;
        half = half.length == n ? half : new double[n];
        image = image.length == n ? image : new double[n];
        for (int from = 0; from < 2 * n; from += n) {
            System.arraycopy(x, from, half, 0, n);
            applyInverse(half, image);
            System.arraycopy(image, 0, y, from, n);
        }
    }

    /** The block Jacobi preconditioner: the inverses of the 3 x 3 diagonal blocks. */
    static final class BlockJacobi implements LinearOperator {
        private final SolverWork work;
        private double[] inverse = {};

        BlockJacobi(SolverWork work) {
            this.work = work;
        }

        /** Inverts the diagonal blocks of a matrix; false if one is singular. */
        boolean prepare(BlockMatrix matrix) {
            BlockPattern pattern = matrix.getPattern();
            if (inverse.length != 9 * pattern.rows) {
                inverse = new double[9 * pattern.rows];
            }
            for (int i = 0; i < pattern.rows; i++) {
                if (!Block3.invert(matrix.getValues(), 9 * pattern.diagonal[i], inverse, 9 * i)) {
                    return false;
                }
            }
            return true;
        }

        @Override
        public void apply(double[] x, double[] y) {
            Arrays.fill(y, 0);
            for (int at = 0, v = 0; at < inverse.length; at += 9, v += 3) {
                Block3.addProduct(1, inverse, at, false, x, v, y, v);
            }
            work.blockOperations += inverse.length / 9;
        }
    }
}
