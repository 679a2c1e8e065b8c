package deSolvers.linear;

import deSolvers.JacobianStateSource;
import java.util.Arrays;

/**
 * The sparse matrix A = M - g C - g<sup>2</sup> K of the velocities' equation, with C = dF/dv and K = dF/dx collected
 * block by block from the source. Rows of held particles are those of the unit matrix.
 */
public final class BlockMatrix extends BlockCollector implements LinearOperator {
    /**
     * Blocks differ from their mirror images by rounding where the forces have a potential, and by far more elsewhere.
     */
    private static final double SYMMETRIC = 1e-13;

    private final ImplicitWork.Counter work;
    private double[] value = {};
    private double gamma;
    private double[] state;
    /** For each row: the sum of |K| |x|, by which rounding of positions enters the forces. */
    private double[] forceScale = {};
    private final double[] product = new double[9];
    private boolean symmetric;
    private boolean definite;
    private final NegativeSemidefinitePart clamp = new NegativeSemidefinitePart();
    private final double[] clamped = new double[9];
    private double stiffening;

    public BlockMatrix(ImplicitWork.Counter work) {
        this.work = work;
    }

    /**
     * Collects the blocks at the source's present state.
     *
     * @param source  gives them
     * @param state   that state
     * @param gamma   g (s)
     * @param masses  of the particles, 0 for held ones
     * @param definite whether to leave out what could make A indefinite: the part of each pair's K that pushes
     *                 outwards, as
     *                across a compressed spring, and what is not symmetric
     */
    public void collect(JacobianStateSource source, double[] state, double gamma, double[] masses, boolean definite) {
        this.definite = definite;
        this.gamma = gamma;
        this.state = state;
        work.jacobians++;
        fill(source, masses.length);
        finish(masses);
    }

    @Override
    void resize() {
        value = new double[9 * pattern().blocks()];
        forceScale = new double[3 * pattern().rows];
    }

    @Override
    void clear() {
        Arrays.fill(value, 0);
        Arrays.fill(forceScale, 0);
    }

    @Override
    public void add(int i, int j, double[] dFdX, double[] dFdV) {
        // has its place in any pattern: contacts come and go without a new one
        if (i == j) {
            if (hasRows()) {
                addTo(pattern().diagonal[i], dFdX, dFdV, -1);
                addForceScale(i, dFdX, i);
            }
            return;
        }
        int p = next(i, j);
        if (p >= 0) {
            addTo(pattern().slot[p], dFdX, dFdV, -1);
            addForceScale(i, dFdX, j);
        }
    }

    @Override
    public void addPair(int i, int j, double[] dFdX, double[] dFdV) {
        int p = next(i, j);
        if (p >= 0 && definite) {
            clamp.restoring(dFdX, clamped);
            addPairBlocks(p, i, j, clamped, dFdV);
        } else if (p >= 0) {
            addPairBlocks(p, i, j, dFdX, dFdV);
        }
    }

    private void addPairBlocks(int p, int i, int j, double[] dFdX, double[] dFdV) {
        addTo(pattern().diagonal[i], dFdX, dFdV, -1);
        addTo(pattern().diagonal[j], dFdX, dFdV, -1);
        addTo(pattern().slot[p], dFdX, dFdV, 1);
        addTo(pattern().mirrorSlot[p], dFdX, dFdV, 1);
        addForceScale(i, dFdX, i);
        addForceScale(i, dFdX, j);
        addForceScale(j, dFdX, i);
        addForceScale(j, dFdX, j);
    }

    @Override
    public void transformRow(int i, double[] matrix) {
        if (!hasRows()) {
            return;
        }
        pattern().transformRow(i, matrix, value, product);
        System.arraycopy(forceScale, 3 * i, product, 0, 3);
        for (int c = 0; c < 3; c++) {
            forceScale[3 * i + c] = Math.abs(matrix[3 * c]) * product[0] + Math.abs(matrix[3 * c + 1]) * product[1]
                    + Math.abs(matrix[3 * c + 2]) * product[2];
        }
    }

    private void addTo(int slot, double[] dFdX, double[] dFdV, double sign) {
        double c = sign * gamma;
        double k = c * gamma;
        for (int e = 0, at = 9 * slot; e < 9; e++, at++) {
            value[at] += c * dFdV[e] + k * dFdX[e];
        }
    }

    private void addForceScale(int i, double[] dFdX, int j) {
        double x = Math.abs(state[6 * j]);
        double y = Math.abs(state[6 * j + 1]);
        double z = Math.abs(state[6 * j + 2]);
        for (int c = 0; c < 3; c++) {
            forceScale[3 * i + c] += Math.abs(dFdX[3 * c]) * x + Math.abs(dFdX[3 * c + 1]) * y
                    + Math.abs(dFdX[3 * c + 2]) * z;
        }
    }

    /** Adds the masses, makes held rows those of the unit matrix, and looks at what came together. */
    private void finish(double[] masses) {
        BlockPattern pattern = pattern();
        symmetric = true;
        stiffening = 1;
        for (int i = 0; i < pattern.rows; i++) {
            int diagonal = 9 * pattern.diagonal[i];
            if (masses[i] == 0) {
                Arrays.fill(value, 9 * pattern.rowStart[i], 9 * pattern.rowStart[i + 1], 0);
            }
            double mass = masses[i] == 0 ? 1 : masses[i];
            value[diagonal] += mass;
            value[diagonal + 4] += mass;
            value[diagonal + 8] += mass;
            double trace = Math.abs(value[diagonal]) + Math.abs(value[diagonal + 4]) + Math.abs(value[diagonal + 8]);
            stiffening = Math.max(stiffening, trace / mass);
            for (int s = pattern.rowStart[i]; s < pattern.diagonal[i] && masses[i] != 0 && symmetric; s++) {
                int j = pattern.column[s];
                symmetric = masses[j] == 0 || isMirror(s, pattern.find(j, i), trace);
            }
            symmetric &= isMirror(pattern.diagonal[i], pattern.diagonal[i], trace);
        }
    }

    private boolean isMirror(int slot, int mirror, double scale) {
        for (int a = 0; a < 3; a++) {
            for (int b = 0; b < 3; b++) {
                if (Math.abs(value[9 * slot + 3 * a + b] - value[9 * mirror + 3 * b + a]) > SYMMETRIC * scale) {
                    return false;
                }
            }
        }
        return true;
    }

    @Override
    public void apply(double[] x, double[] y) {
        BlockPattern pattern = pattern();
        work.blockOperations += pattern.blocks();
        int[] column = pattern.column;
        for (int i = 0, yAt = 0; i < pattern.rows; i++, yAt += 3) {
            double y0 = 0;
            double y1 = 0;
            double y2 = 0;
            for (int s = pattern.rowStart[i], end = pattern.rowStart[i + 1]; s < end; s++) {
                int at = 9 * s;
                int xAt = 3 * column[s];
                double x0 = x[xAt];
                double x1 = x[xAt + 1];
                double x2 = x[xAt + 2];
                y0 += value[at] * x0 + value[at + 1] * x1 + value[at + 2] * x2;
                y1 += value[at + 3] * x0 + value[at + 4] * x1 + value[at + 5] * x2;
                y2 += value[at + 6] * x0 + value[at + 7] * x1 + value[at + 8] * x2;
            }
            y[yAt] = y0;
            y[yAt + 1] = y1;
            y[yAt + 2] = y2;
        }
    }

    public double[] values() {
        return value;
    }

    public double[] forceScale() {
        return forceScale;
    }

    /** Whether A is its own mirror image, leaving out held particles. */
    public boolean isSymmetric() {
        return symmetric;
    }

    /**
     * About the condition number of A after scaling by its diagonal blocks: how many times the springs, seen through
     * the step, are stiffer than the inertia of the particle on which they act most; about (g omega)<sup>2</sup>.
     */
    public double condition() {
        return stiffening;
    }
}
