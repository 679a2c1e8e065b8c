package deSolvers.linear;

import java.util.Arrays;

/** The block Jacobi preconditioner: the inverses of the 3 x 3 diagonal blocks. */
final class BlockJacobi implements LinearOperator {
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
