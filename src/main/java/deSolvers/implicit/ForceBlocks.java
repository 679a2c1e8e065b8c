package deSolvers.implicit;

import deSolvers.ForceDerivatives;
import deSolvers.JacobianStateSource;
import deSolvers.linear.BlockMatrix;
import deSolvers.linear.BlockPattern;
import deSolvers.linear.SolverWork;
import java.util.Arrays;
import java.util.stream.LongStream;

/**
 * The force derivatives of particles, K = dF/dx and C = dF/dv, as sparse matrices. The source names its blocks one by
 * one; where it names others than before, the pattern is found anew. The mass of a held
 * particle counts as 1, and its rows are 0, so that nothing moves it.
 */
final class ForceBlocks implements ForceDerivatives {
    private final SolverWork work;
    private final NegativeSemidefinitePart projection = new NegativeSemidefinitePart();
    private final double[] projected = new double[9];
    private final double[] row = new double[9];
    private BlockPattern pattern;
    private BlockMatrix stiffness;
    private BlockMatrix damping;
    private double[] masses = {};
    private boolean[] held = {};
    private boolean projects;
    private int named;                                  // pairs so far
    private int known;                                  // pairs from which the pattern was made
    private boolean matches;                            // whether all pairs so far have a place in the pattern
    private boolean recording;
    private LongStream.Builder pairs = LongStream.builder();

    ForceBlocks(SolverWork work) {
        this.work = work;
        setPattern(0);
    }

    /**
     * Collects the blocks at the source's present state.
     *
     * @param projects whether to take the negative semidefinite part of each pair's dF/dx
     */
    void collect(JacobianStateSource source, int particles, boolean projects) {
        this.projects = projects;
        receive(source, particles);
        if (!matches || named != known) {
            recording = true;
            pairs = LongStream.builder();
            source.addJacobianBlocks(this);
            recording = false;
            setPattern(particles);
            receive(source, particles);
        }
        if (masses.length != particles) {
            masses = new double[particles];
            held = new boolean[particles];
        }
        for (int i = 0; i < particles; i++) {
            double inverse = source.getInverseMass(i);
            held[i] = inverse == 0;
            masses[i] = held[i] ? 1 : 1 / inverse;
            if (held[i]) {
                Arrays.fill(stiffness.getValues(), 9 * pattern.rowStart(i), 9 * pattern.rowStart(i + 1), 0);
                Arrays.fill(damping.getValues(), 9 * pattern.rowStart(i), 9 * pattern.rowStart(i + 1), 0);
            }
        }
    }

    private void setPattern(int particles) {
        long[] recorded = pairs.build().toArray();
        known = recorded.length;
        pattern = new BlockPattern(particles, recorded);
        stiffness = new BlockMatrix(pattern, work);
        damping = new BlockMatrix(pattern, work);
    }

    private void receive(JacobianStateSource source, int particles) {
        Arrays.fill(stiffness.getValues(), 0);
        Arrays.fill(damping.getValues(), 0);
        named = 0;
        matches = pattern.getRows() == particles;
        source.addJacobianBlocks(this);
    }

    BlockPattern getPattern() {
        return pattern;
    }

    BlockMatrix getStiffness() {
        return stiffness;
    }

    BlockMatrix getDamping() {
        return damping;
    }

    /** The mass of a particle (kg); 1 if it is held. */
    double mass(int i) {
        return masses[i];
    }

    /**
     * Writes M - g C - g<sup>2</sup> K, without the columns of held particles, whose velocities never change.
     *
     * @return the largest ratio of a diagonal entry to its mass: about the condition number, 1 or more
     */
    double combine(double g, BlockMatrix matrix) {
        double[] value = matrix.getValues();
        double condition = 1;
        for (int i = 0; i < masses.length; i++) {
            for (int s = pattern.rowStart(i); s < pattern.rowStart(i + 1); s++) {
                boolean zero = held[pattern.column(s)];
                for (int e = 9 * s; e < 9 * s + 9; e++) {
                    value[e] = zero ? 0 : -g * (damping.getValues()[e] + g * stiffness.getValues()[e]);
                }
            }
            int diagonal = 9 * pattern.diagonal(i);
            for (int e = diagonal; e < diagonal + 9; e += 4) {
                value[e] += masses[i];
                condition = Math.max(condition, Math.abs(value[e]) / masses[i]);
            }
        }
        return condition;
    }

    /** The slot of a block beside the diagonal that is named now; negative if it has none (yet). */
    private int slot(int i, int j) {
        named++;
        if (recording) {
            pairs.add(BlockPattern.place(i, j));
            return -1;
        }
        int slot = matches ? pattern.find(i, j) : -1;
        matches = slot >= 0;
        return slot;
    }

    @Override
    public void add(int i, int j, double[] dFdX, double[] dFdV) {
        if (i != j) {
            int slot = slot(i, j);
            if (slot >= 0) {
                addTo(slot, dFdX, dFdV, 1);
            }
        } else if (!recording && matches) {
            // any pattern has the diagonal, so that contacts come and go without a new one
            addTo(pattern.diagonal(i), dFdX, dFdV, 1);
        }
    }

    @Override
    public void addPair(int i, int j, double[] dFdX, double[] dFdV) {
        int slot = slot(i, j);
        if (slot >= 0) {
            double[] k = dFdX;
            if (projects) {
                projection.compute(dFdX, projected);
                k = projected;
            }
            addTo(pattern.diagonal(i), k, dFdV, 1);
            addTo(pattern.diagonal(j), k, dFdV, 1);
            addTo(slot, k, dFdV, -1);
            addTo(pattern.find(j, i), k, dFdV, -1);
        }
    }

    private void addTo(int slot, double[] dFdX, double[] dFdV, double sign) {
        for (int e = 0, at = 9 * slot; e < 9; e++, at++) {
            stiffness.getValues()[at] += sign * dFdX[e];
            damping.getValues()[at] += sign * dFdV[e];
        }
    }

    @Override
    public void transformRow(int i, double[] matrix) {
        if (!recording && matches) {
            stiffness.transformRow(i, matrix, row);
            damping.transformRow(i, matrix, row);
        }
    }
}
