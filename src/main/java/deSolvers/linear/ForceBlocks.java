package deSolvers.linear;

import deSolvers.JacobianStateSource;
import java.util.Arrays;

/**
 * The force derivatives of particles, K = dF/dx and C = dF/dv, block by block as the source names them: for methods
 * that need them with more than one length of step. Rows of held particles are 0, and their masses 1, so that nothing
 * moves them.
 */
public final class ForceBlocks extends BlockCollector {
    private final ImplicitWork.Counter work;
    private double[] stiffness = {};
    private double[] damping = {};
    private double[] masses = {};
    private final double[] product = new double[9];

    public ForceBlocks(ImplicitWork.Counter work) {
        this.work = work;
    }

    /** Collects the blocks at the source's present state. */
    public void collect(JacobianStateSource source, int particles) {
        work.jacobians++;
        if (masses.length != particles) {
            masses = new double[particles];
        }
        fill(source, particles);
        BlockPattern pattern = pattern();
        for (int i = 0; i < particles; i++) {
            double inverse = source.getInverseMass(i);
            masses[i] = inverse == 0 ? 1 : 1 / inverse;
            if (inverse == 0) {
                Arrays.fill(stiffness, 9 * pattern.rowStart[i], 9 * pattern.rowStart[i + 1], 0);
                Arrays.fill(damping, 9 * pattern.rowStart[i], 9 * pattern.rowStart[i + 1], 0);
            }
        }
    }

    /** The mass of a particle (kg); 1 if it is held. */
    public double mass(int i) {
        return masses[i];
    }

    /**
     * Writes the values of M - g C - g<sup>2</sup> K.
     *
     * @return how many times the largest diagonal block exceeds its mass: about the condition number, 1 or more
     */
    public double combine(double g, double[] values) {
        for (int e = 0; e < stiffness.length; e++) {
            values[e] = -g * (damping[e] + g * stiffness[e]);
        }
        double stiffening = 1;
        for (int i = 0; i < masses.length; i++) {
            int diagonal = 9 * pattern().diagonal[i];
            double trace = 0;
            for (int d = diagonal; d < diagonal + 9; d += 4) {
                values[d] += masses[i];
                trace += Math.abs(values[d]);
            }
            stiffening = Math.max(stiffening, trace / (3 * masses[i]));
        }
        return stiffening;
    }

    /** The forces K x + C v; three entries a particle in all arrays. */
    public void apply(double[] x, double[] v, double[] force) {
        BlockPattern pattern = pattern();
        work.blockOperations += 2L * pattern.blocks();
        for (int i = 0, to = 0; i < pattern.rows; i++, to += 3) {
            double f0 = 0;
            double f1 = 0;
            double f2 = 0;
            for (int s = pattern.rowStart[i]; s < pattern.rowStart[i + 1]; s++) {
                int at = 9 * s;
                int from = 3 * pattern.column[s];
                double x0 = x[from];
                double x1 = x[from + 1];
                double x2 = x[from + 2];
                double v0 = v[from];
                double v1 = v[from + 1];
                double v2 = v[from + 2];
                f0 += stiffness[at] * x0 + stiffness[at + 1] * x1 + stiffness[at + 2] * x2
                        + damping[at] * v0 + damping[at + 1] * v1 + damping[at + 2] * v2;
                f1 += stiffness[at + 3] * x0 + stiffness[at + 4] * x1 + stiffness[at + 5] * x2
                        + damping[at + 3] * v0 + damping[at + 4] * v1 + damping[at + 5] * v2;
                f2 += stiffness[at + 6] * x0 + stiffness[at + 7] * x1 + stiffness[at + 8] * x2
                        + damping[at + 6] * v0 + damping[at + 7] * v1 + damping[at + 8] * v2;
            }
            force[to] = f0;
            force[to + 1] = f1;
            force[to + 2] = f2;
        }
    }

    @Override
    void resize() {
        stiffness = new double[9 * pattern().blocks()];
        damping = new double[9 * pattern().blocks()];
    }

    @Override
    void clear() {
        Arrays.fill(stiffness, 0);
        Arrays.fill(damping, 0);
    }

    @Override
    public void add(int i, int j, double[] dFdX, double[] dFdV) {
        if (i == j) {                                   // has its place in any pattern
            if (hasRows()) {
                addTo(pattern().diagonal[i], dFdX, dFdV, 1);
            }
            return;
        }
        int p = next(i, j);
        if (p >= 0) {
            addTo(pattern().slot[p], dFdX, dFdV, 1);
        }
    }

    @Override
    public void addPair(int i, int j, double[] dFdX, double[] dFdV) {
        int p = next(i, j);
        if (p >= 0) {
            addTo(pattern().diagonal[i], dFdX, dFdV, 1);
            addTo(pattern().diagonal[j], dFdX, dFdV, 1);
            addTo(pattern().slot[p], dFdX, dFdV, -1);
            addTo(pattern().mirrorSlot[p], dFdX, dFdV, -1);
        }
    }

    private void addTo(int slot, double[] dFdX, double[] dFdV, double sign) {
        for (int e = 0, at = 9 * slot; e < 9; e++, at++) {
            stiffness[at] += sign * dFdX[e];
            damping[at] += sign * dFdV[e];
        }
    }

    @Override
    public void transformRow(int i, double[] matrix) {
        if (hasRows()) {
            pattern().transformRow(i, matrix, stiffness, product);
            pattern().transformRow(i, matrix, damping, product);
        }
    }
}
