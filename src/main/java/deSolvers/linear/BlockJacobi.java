package deSolvers.linear;

/** The preconditioner that inverts the diagonal blocks of a matrix, one particle at a time. */
public final class BlockJacobi implements LinearOperator {
    private final ImplicitWork.Counter work;
    private double[] inverse = {};

    public BlockJacobi(ImplicitWork.Counter work) {
        this.work = work;
    }

    /** Takes up a matrix, the values in their pattern; false if a diagonal block is singular. */
    public boolean prepare(BlockPattern pattern, double[] values) {
        if (inverse.length != 9 * pattern.rows) {
            inverse = new double[9 * pattern.rows];
        }
        for (int i = 0; i < pattern.rows; i++) {
            if (!Block3.invert(values, 9 * pattern.diagonal[i], inverse, 9 * i)) {
                return false;
            }
        }
        return true;
    }

    @Override
    public void apply(double[] x, double[] y) {
        java.util.Arrays.fill(y, 0);
        for (int at = 0, v = 0; at < inverse.length; at += 9, v += 3) {
            Block3.multiplyAdd(inverse, at, x, v, y, v);
        }
        work.blockOperations += inverse.length / 9;
    }
}
