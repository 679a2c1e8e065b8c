package deSolvers.implicit;

import deSolvers.ForceDerivatives;
import deSolvers.JacobianStateSource;
import deSolvers.linear.BlockMatrix;
import deSolvers.linear.BlockPattern;
import deSolvers.linear.Gmres;
import deSolvers.linear.SolverWork;
import java.util.Arrays;
import java.util.function.BiConsumer;

/**
 * The force derivatives of particles, K = dF/dx and C = dF/dv, at one state: sparse matrices of blocks, or differences
 * of f where the blocks are not the whole derivative. The source names its blocks one by one; where it names others
 * than before, the pattern is found anew. The mass of a held particle counts as 1, and its rows are 0, so that nothing
 * moves it. Vectors have three entries per particle.
 */
public final class ForceJacobian implements ForceDerivatives {
    private final SolverWork work;
    private final BiConsumer<double[], double[]> derivative;
    private final double[] base;
    private final double[] slope;                       // f there
    private final double[] varied;
    private final double[] variedSlope;
    private final double[] zero;
    private final double[] term;
    private double size;                                // of the base
    private boolean exact;
    private boolean inContact;                          // whether a reaction has transformed rows
    private final NegativeSemidefinitePart projection = new NegativeSemidefinitePart();
    private final double[] projected = new double[9];
    private final double[] row = new double[9];
    private BlockPattern pattern;
    private BlockMatrix stiffness;
    private BlockMatrix damping;
    private final double[] masses;
    private final boolean[] held;
    private boolean projects;
    private int named;                                  // pairs so far
    private int known;                                  // pairs from which the pattern was made
    private boolean matches;                            // whether all pairs so far have a place in the pattern
    private long[] pairs = {};

    /**
     * @param work       counts the products by differences
     * @param n          the state's size
     * @param derivative evaluates f at a state, for differences
     */
    public ForceJacobian(SolverWork work, int n, BiConsumer<double[], double[]> derivative) {
        this.work = work;
        this.derivative = derivative;
        base = new double[n];
        slope = new double[n];
        varied = new double[n];
        variedSlope = new double[n];
        zero = new double[n / 2];
        term = new double[n / 2];
        masses = new double[n / 6];
        held = new boolean[n / 6];
        setPattern();
    }

    /**
     * Sets up K and C.
     *
     * @param source   the particles; they are in this state
     * @param state    the state; copied
     * @param slope    f at that state; copied
     * @param projects whether to take the negative semidefinite part of each pair's dF/dx in the blocks
     */
    public void setUp(JacobianStateSource source, double[] state, double[] slope, boolean projects) {
        exact = source.hasExactJacobian();
        this.projects = projects;
        System.arraycopy(state, 0, base, 0, base.length);
        System.arraycopy(slope, 0, this.slope, 0, base.length);
        size = Gmres.norm(base);
        size = size == 0 ? 1 : size;
        receive(source);
        if (!matches || named != known) {
            setPattern();
            receive(source);
        }
        for (int i = 0; i < masses.length; i++) {
            double inverse = source.getInverseMass(i);
            held[i] = inverse == 0;
            masses[i] = held[i] ? 1 : 1 / inverse;
            if (held[i]) {
                stiffness.clearRow(i);
                damping.clearRow(i);
            }
        }
    }

    private void setPattern() {
        known = named;
        pattern = new BlockPattern(masses.length, Arrays.copyOf(pairs, named));
        stiffness = new BlockMatrix(pattern, work);
        damping = new BlockMatrix(pattern, work);
    }

    private void receive(JacobianStateSource source) {
        Arrays.fill(stiffness.getValues(), 0);
        Arrays.fill(damping.getValues(), 0);
        named = 0;
        matches = true;
        inContact = false;
        source.addJacobianBlocks(this);
    }

    /** Whether the blocks are the whole derivative. */
    boolean isExact() {
        return exact;
    }

    /** Whether a contact's force, which depends on all others, is in the blocks. */
    boolean isInContact() {
        return inContact;
    }

    BlockPattern getPattern() {
        return pattern;
    }

    /** The mass of a particle (kg); 1 if it is held. */
    double mass(int i) {
        return masses[i];
    }

    /** Computes K x. */
    void multiply(double[] x, double[] force) {
        multiply(x, zero, force);
    }

    /** Multiplies by the absolute values of K, or by K where the blocks are not the whole derivative. */
    void multiplyAbsolute(double[] x, double[] force) {
        if (exact) {
            stiffness.applyAbsolute(x, force);
        } else {
            multiply(x, force);
        }
    }

    /**
     * Computes K x + C v.
     *
     * @param x     displacements (m)
     * @param v     changes of velocities (m/s)
     * @param force receives the change of the forces (N); 0 for held particles
     */
    public void multiply(double[] x, double[] v, double[] force) {
        if (exact) {
            stiffness.apply(x, force);
            if (v != zero) {
                damping.apply(v, term);
                for (int i = 0; i < force.length; i++) {
                    force[i] += term[i];
                }
            }
            return;
        }
        double length = Math.sqrt(Gmres.dot(x, x) + Gmres.dot(v, v));
        if (length == 0) {
            Arrays.fill(force, 0);
            return;
        }
        double delta = DenseSystem.ROOT_EPSILON * size / length;
        for (int i = 0; i < force.length; i++) {
            varied[place(i)] = base[place(i)] + delta * x[i];
            varied[place(i) + 3] = base[place(i) + 3] + delta * v[i];
        }
        work.products++;
        derivative.accept(varied, variedSlope);
        for (int i = 0; i < force.length; i++) {
            force[i] = masses[i / 3] * (variedSlope[place(i) + 3] - slope[place(i) + 3]) / delta;
        }
    }

    /** Each coordinate's place in the state; that of its velocity is 3 further on. */
    static int place(int i) {
        return 6 * (i / 3) + i % 3;
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
        if (named == pairs.length) {
            pairs = Arrays.copyOf(pairs, 2 * named + 1);
        }
        pairs[named++] = BlockPattern.place(i, j);
        int slot = pattern.find(i, j);
        matches &= slot >= 0;
        return slot;
    }

    @Override
    public void add(int i, int j, double[] dFdX, double[] dFdV) {
        if (i != j) {
            int slot = slot(i, j);
            if (slot >= 0) {
                addTo(slot, dFdX, dFdV, 1);
            }
        } else {
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
        inContact = true;
        stiffness.transformRow(i, matrix, row);
        damping.transformRow(i, matrix, row);
    }
}
