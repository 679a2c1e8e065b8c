package deSolvers.linear;

import java.util.Arrays;

/**
 * A = L D U of a sparse matrix of 3 x 3 blocks with a symmetric pattern, front by front as {@link FrontalPlan} says; of
 * a symmetric matrix U = L<sup>T</sup>, at half the work. The elimination keeps to its order and does not pivot outside
 * the diagonal blocks; GMRES, which uses the factors as its preconditioner, makes good what little accuracy that costs.
 */
public final class FrontalFactors implements LinearOperator {
    private final ImplicitWork.Counter work;
    private BlockPattern pattern;
    private FrontalPlan plan;
    private boolean symmetric;
    private double[] inverse = {};                      // of the diagonal blocks D
    // D U: for each particle three rows, right of the diagonal block
    private double[] right = {};
    private double[] below = {};                        // (L D)^T in the same shape
    private Front front;                                // null until there is a matrix of this pattern
    private final double[] block = new double[9];
    private double[] solution = {};
    private double[] part = {};

    public FrontalFactors(ImplicitWork.Counter work) {
        this.work = work;
    }

    /** Whether the factors of this pattern have no more blocks than the given number; finds the plan if it is new. */
    public boolean fits(BlockPattern pattern, long mostBlocks) {
        if (this.pattern != pattern) {
            this.pattern = pattern;
            plan = new FrontalPlan(pattern, mostBlocks / 2);
            front = null;
            right = new double[0];                      // both can be large, and belonged to the pattern before
            below = new double[0];
        }
        return plan.fits;
    }

    private void makeRoom() {
        int n = pattern.rows;
        inverse = new double[9 * n];
        right = new double[(int) (9 * plan.blocks)];
        front = new Front(pattern, plan);
        solution = new double[3 * n];
        part = new double[3 * plan.largestFront];
    }

    /**
     * Factorises the matrix with these values in the pattern that {@link #fits}.
     *
     * @param symmetric whether its blocks are each other's mirror images, except that rows of the unit matrix may have
     *                  others in their columns; these are left out then
     * @return false if a diagonal block is singular
     */
    public boolean factorise(double[] a, boolean symmetric) {
        this.symmetric = symmetric;
        if (front == null) {
            makeRoom();
        }
        work.factorisations++;
        work.blockOperations += operations(symmetric);
        if (!symmetric && below.length != right.length) {
            below = new double[right.length];
        }
        front.begin(a, symmetric);
        int to = 0;
        for (int g = 0; g < plan.groups; g++) {
            int rows = front.assemble(g);
            for (int k = 0; k < 3 * plan.width(g); k += 3) {
                int inverseAt = 3 * (3 * plan.groupStart[g] + k);
                front.copyPivot(k, block);
                if (!Block3.invert(block, 0, inverse, inverseAt)) {
                    return false;
                }
                front.copyRows(k, right, to);
                if (!symmetric) {
                    front.copyColumns(k, below, to);
                }
                front.eliminate(k, inverse, inverseAt);
                to += 3 * (rows - k - 3);
            }
            front.keepLeft();
        }
        return true;
    }

    /** y = A<sup>-1</sup> x, as far as the factors are exact. */
    @Override
    public void apply(double[] x, double[] y) {
        work.blockOperations += blocks();
        for (int k = 0; k < pattern.rows; k++) {
            System.arraycopy(x, 3 * plan.order[k], solution, 3 * k, 3);
        }
        int to = 0;
        for (int g = 0; g < plan.groups; g++) {
            to = applyBelow(g, to);
        }
        for (int g = plan.groups - 1; g >= 0; g--) {
            to = applyRight(g, to);
        }
        for (int k = 0; k < pattern.rows; k++) {
            System.arraycopy(solution, 3 * k, y, 3 * plan.order[k], 3);
        }
    }

    /** Takes the rows of a group's front out of the solution. */
    private int gather(int g) {
        int width = 3 * plan.width(g);
        System.arraycopy(solution, 3 * plan.groupStart[g], part, 0, width);
        for (int b = plan.belowStart[g], r = width; b < plan.belowStart[g + 1]; b++, r += 3) {
            System.arraycopy(solution, 3 * plan.below[b], part, r, 3);
        }
        return width + 3 * plan.height(g);
    }

    private int applyBelow(int g, int from) {
        int rows = gather(g);
        int width = 3 * plan.width(g);
        double[] factors = symmetric ? right : below;
        int at = from;
        for (int k = 0; k < width; k += 3) {
            int length = rows - k - 3;
            Arrays.fill(block, 0, 3, 0);
            Block3.multiplyAdd(inverse, 3 * (3 * plan.groupStart[g] + k), part, k, block, 0);
            System.arraycopy(block, 0, part, k, 3);
            for (int c = 0; c < 3; c++, at += length) { // one after the other: such loops become vector instructions
                double x = block[c];
                for (int r = k + 3, e = at; r < rows; r++, e++) {
                    part[r] -= factors[e] * x;
                }
            }
        }
        System.arraycopy(part, 0, solution, 3 * plan.groupStart[g], width);
        for (int b = plan.belowStart[g], r = width; b < plan.belowStart[g + 1]; b++, r += 3) {
            System.arraycopy(part, r, solution, 3 * plan.below[b], 3);
        }
        return at;
    }

    private int applyRight(int g, int end) {
        int rows = gather(g);
        int width = 3 * plan.width(g);
        int at = end;
        for (int k = width - 3; k >= 0; k -= 3) {
            int length = rows - k - 3;
            at -= 3 * length;
            double sum0 = 0;
            double sum1 = 0;
            double sum2 = 0;
            for (int r = k + 3, e = at; r < rows; r++, e++) {
                double value = part[r];
                sum0 += right[e] * value;
                sum1 += right[e + length] * value;
                sum2 += right[e + 2 * length] * value;
            }
            block[0] = sum0;
            block[1] = sum1;
            block[2] = sum2;
            Block3.multiplySubtract(inverse, 3 * (3 * plan.groupStart[g] + k), block, 0, part, k);
        }
        System.arraycopy(part, 0, solution, 3 * plan.groupStart[g], width);
        return at;
    }

    /** Products of a block with three entries that {@link #apply} takes. */
    public long blocks() {
        return 2 * plan.blocks + pattern.rows;
    }

    /** What a factorisation takes, in such products. */
    public long cost() {
        return 3 * operations(symmetric);
    }

    /**
     * Products of blocks that a factorisation takes, and then one {@link #apply}; they take as long as those of
     * iterations.
     */
    public long work(boolean symmetric) {
        return operations(symmetric) + blocks();
    }

    private long operations(boolean symmetric) {
        return symmetric ? plan.symmetricOperations : plan.operations;
    }
}
