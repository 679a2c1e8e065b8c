package deSolvers.implicit;

import deSolvers.JacobianStateSource;
import deSolvers.linear.Gmres;
import deSolvers.linear.SolverWork;
import java.util.Arrays;
import java.util.function.BiConsumer;

/**
 * Multiplies with the force derivatives of particles, K = dF/dx and C = dF/dv, at one state: by their blocks, or by a
 * difference of f where the blocks are not the whole derivative. Vectors have three entries per particle.
 */
public final class ForceJacobian {
    private final SolverWork work;
    private final BiConsumer<double[], double[]> derivative;
    private final ForceBlocks blocks;
    private final double[] base;
    private final double[] slope;                       // f there
    private final double[] varied;
    private final double[] variedSlope;
    private final double[] zero;
    private final double[] term;
    private double size;                                // of the base
    private boolean exact;

    /**
     * @param work       counts the products by differences
     * @param n          the state's size
     * @param derivative evaluates f at a state, for differences
     */
    public ForceJacobian(SolverWork work, int n, BiConsumer<double[], double[]> derivative) {
        this.work = work;
        this.derivative = derivative;
        blocks = new ForceBlocks(work);
        base = new double[n];
        slope = new double[n];
        varied = new double[n];
        variedSlope = new double[n];
        zero = new double[n / 2];
        term = new double[n / 2];
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
        System.arraycopy(state, 0, base, 0, base.length);
        System.arraycopy(slope, 0, this.slope, 0, base.length);
        size = Gmres.norm(base);
        size = size == 0 ? 1 : size;
        blocks.collect(source, base.length / 6, projects);
    }

    /** Whether the blocks are the whole derivative. */
    boolean isExact() {
        return exact;
    }

    ForceBlocks getBlocks() {
        return blocks;
    }

    /** Computes K x. */
    void multiply(double[] x, double[] force) {
        multiply(x, zero, force);
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
            blocks.getStiffness().apply(x, force);
            if (v != zero) {
                blocks.getDamping().apply(v, term);
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
            force[i] = blocks.mass(i / 3) * (variedSlope[place(i) + 3] - slope[place(i) + 3]) / delta;
        }
    }

    /** Each coordinate's place in the state; that of its velocity is 3 further on. */
    static int place(int i) {
        return 6 * (i / 3) + i % 3;
    }
}
