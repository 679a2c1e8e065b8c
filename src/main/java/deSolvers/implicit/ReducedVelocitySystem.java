package deSolvers.implicit;

import deSolvers.DEStateSource;
import deSolvers.JacobianStateSource;
import deSolvers.StepTransaction;
import deSolvers.linear.BlockMatrix;
import deSolvers.linear.BlockSolver;
import deSolvers.linear.Gmres;
import deSolvers.linear.LinearOperator;
import deSolvers.linear.SolverWork;
import java.util.Arrays;

/**
 * I - g J for particles in space that offer the 3 x 3 blocks of their force derivatives. The positions are eliminated:
 * with b = (b<sub>x</sub>, b<sub>v</sub>) the solution is x = b<sub>x</sub> + g v, where
 * <blockquote>
 * (M - g C - g<sup>2</sup> K) v = M b<sub>v</sub> + g K b<sub>x</sub>,
 * </blockquote>
 * K = dF/dx and C = dF/dv, for real and complex g. This matrix is half as large, sparse, and symmetric where the forces
 * have a potential.
 *
 * <p>With a complex g GMRES solves it, preconditioned by the solver of the real g. That leaves eigenvalues between 1
 * and (g<sub>complex</sub>/g<sub>real</sub>)<sup>2</sup>, however stiff the springs are.
 */
final class ReducedVelocitySystem implements ShiftedJacobian {
    private final SolverWork work;
    private final ForceBlocks blocks;
    private final BlockSolver solver;
    private final LinearOperator products = this::applyReal;
    private final LinearOperator complex = this::applyComplex;
    private BlockMatrix matrix;
    private final int m;                                // 3 per particle
    private final double[] realRight;
    private final double[] realVelocities;
    private final double[] right;                       // real parts first, then imaginary ones
    private final double[] velocities;
    private final double[] positions;
    private final double[] partPositions;
    private final double[] partVelocities;
    private final double[] partForces;
    private final double[] zero;
    private final double[] term;
    private final double[] base;
    private final double[] slope;                       // f there
    private final double[] varied;
    private final double[] variedSlope;
    private double size;                                // of the base
    private StepTransaction source;
    private boolean exact;
    private double g;
    private double gRe;
    private double gIm;

    /** @param n the state's size */
    ReducedVelocitySystem(SolverWork work, int n) {
        this.work = work;
        blocks = new ForceBlocks(work);
        solver = new BlockSolver(work);
        matrix = new BlockMatrix(blocks.getPattern(), work);
        m = n / 2;
        realRight = new double[m];
        realVelocities = new double[m];
        right = new double[n];
        velocities = new double[n];
        positions = new double[n];
        partPositions = new double[m];
        partVelocities = new double[m];
        partForces = new double[m];
        zero = new double[m];
        term = new double[m];
        base = new double[n];
        slope = new double[n];
        varied = new double[n];
        variedSlope = new double[n];
    }

    @Override
    public void setJacobian(StepTransaction source, double[] state, double[] slope, double h, Kind kind) {
        JacobianStateSource client = (JacobianStateSource) source.getClient();
        exact = client.hasExactJacobian();
        work.jacobians++;
        this.source = source;
        System.arraycopy(state, 0, base, 0, base.length);
        System.arraycopy(slope, 0, this.slope, 0, base.length);
        size = Gmres.norm(base);
        size = size == 0 ? 1 : size;
        source.setState(state);
        BlockMatrix before = blocks.getStiffness();
        blocks.collect(client, m / 3, kind != Kind.EXACT);
        if (blocks.getStiffness() != before) {
            matrix = new BlockMatrix(blocks.getPattern(), work);
        }
    }

    /** Differences belong to the place where they are taken. */
    @Override
    public boolean keepsJacobian() {
        return exact;
    }

    @Override
    public void forget() {
        solver.forget();
    }

    /** A stiff cloth that begins to buckle needs some hundreds, each of which leads down to lower energy. */
    @Override
    public int mostIterations() {
        return 1000;
    }

    @Override
    public boolean prepare(double g) {
        this.g = g;
        return solver.prepare(matrix, exact ? matrix : products, blocks.combine(g, matrix));
    }

    @Override
    public boolean prepareComplex(double gRe, double gIm) {
        this.gRe = gRe;
        this.gIm = gIm;
        return true;
    }

    @Override
    public boolean solve(double[] b, double[] x, double tolerance) {
        for (int i = 0; i < m; i++) {
            partPositions[i] = b[place(i)];
        }
        forces(partPositions, zero, partForces);
        for (int i = 0; i < m; i++) {
            realRight[i] = blocks.mass(i / 3) * b[place(i) + 3] + g * partForces[i];
        }
        if (!solver.solve(realRight, realVelocities, tolerance)) {
            return false;
        }
        for (int i = 0; i < m; i++) {
            x[place(i)] = b[place(i)] + g * realVelocities[i];
            x[place(i) + 3] = realVelocities[i];
        }
        return true;
    }

    @Override
    public boolean solveComplex(double[] b, double[] x, double tolerance) {
        for (int half = 0; half < 2; half++) {
            for (int i = 0; i < m; i++) {
                partPositions[i] = b[2 * place(i) + half];
            }
            forces(partPositions, zero, partForces);
            System.arraycopy(partForces, 0, positions, half * m, m);
        }
        for (int i = 0; i < m; i++) {
            double mass = blocks.mass(i / 3);
            right[i] = mass * b[2 * place(i) + 6] + gRe * positions[i] - gIm * positions[m + i];
            right[m + i] = mass * b[2 * place(i) + 7] + gRe * positions[m + i] + gIm * positions[i];
        }
        if (!solver.solveComplex(complex, right, velocities, tolerance)) {
            return false;
        }
        for (int i = 0; i < m; i++) {
            int at = 2 * place(i);
            x[at] = b[at] + gRe * velocities[i] - gIm * velocities[m + i];
            x[at + 1] = b[at + 1] + gRe * velocities[m + i] + gIm * velocities[i];
            x[at + 6] = velocities[i];
            x[at + 7] = velocities[m + i];
        }
        return true;
    }

    /** y = M v - g C v - g^2 K v, where the blocks are not the whole Jacobian. */
    private void applyReal(double[] v, double[] y) {
        for (int i = 0; i < m; i++) {
            partVelocities[i] = g * v[i];
            partPositions[i] = g * partVelocities[i];
        }
        forces(partPositions, partVelocities, y);
        for (int i = 0; i < m; i++) {
            y[i] = blocks.mass(i / 3) * v[i] - y[i];
        }
    }

    /** The same with the complex g: K and C are real, and g makes real and imaginary parts act on each other. */
    private void applyComplex(double[] v, double[] y) {
        double squareRe = gRe * gRe - gIm * gIm;
        double squareIm = 2 * gRe * gIm;
        for (int half = 0; half < 2; half++) {
            int other = half == 0 ? m : 0;
            double sign = half == 0 ? -1 : 1;
            for (int i = 0; i < m; i++) {
                partVelocities[i] = gRe * v[half * m + i] + sign * gIm * v[other + i];
                partPositions[i] = squareRe * v[half * m + i] + sign * squareIm * v[other + i];
            }
            forces(partPositions, partVelocities, partForces);
            for (int i = 0; i < m; i++) {
                y[half * m + i] = blocks.mass(i / 3) * v[half * m + i] - partForces[i];
            }
        }
    }

    /** K x + C v: by the blocks, or by a difference where these are not the whole Jacobian. */
    private void forces(double[] x, double[] v, double[] force) {
        if (exact) {
            blocks.getStiffness().apply(x, force);
            if (v != zero) {
                blocks.getDamping().apply(v, term);
                for (int i = 0; i < m; i++) {
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
        double delta = DenseJacobian.ROOT_EPSILON * size / length;
        for (int i = 0; i < m; i++) {
            varied[place(i)] = base[place(i)] + delta * x[i];
            varied[place(i) + 3] = base[place(i) + 3] + delta * v[i];
        }
        work.products++;
        source.setState(varied);
        source.getStateDerivative(variedSlope);
        for (int i = 0; i < m; i++) {
            force[i] = blocks.mass(i / 3) * (variedSlope[place(i) + 3] - slope[place(i) + 3]) / delta;
        }
    }

    /** Each coordinate's place in the state; that of its velocity is 3 further on. */
    private static int place(int i) {
        return 6 * (i / 3) + i % 3;
    }

    /** The particles where they are, with velocities of 0; with rods as they are, for these bend by v&sup2;. */
    @Override
    public void guess(DEStateSource client, double[] m) {
        for (int i = 0; i < this.m && ((JacobianStateSource) client).hasExactJacobian(); i++) {
            m[place(i) + 3] = 0;
        }
    }

    /** Positions are x + g v. */
    @Override
    public void complete(double[] start, double g, double[] m) {
        for (int i = 0; i < this.m; i++) {
            m[place(i)] = start[place(i)] + g * m[place(i) + 3];
        }
    }

    /**
     * The power of the forces that are left: the slope of an energy, since positions stay x + g v. The forces of rods
     * and friction have no energy; for them it is the natural test, whether the next correction still points ahead.
     */
    @Override
    public double slope(double[] residual, double[] solution, double[] direction) {
        double sum = 0;
        for (int i = 0; i < m; i++) {
            sum += blocks.mass(i / 3) * (exact ? residual : solution)[place(i) + 3] * direction[place(i) + 3];
        }
        return sum;
    }

    /** The accelerations are sums of K x/m, which may cancel; so may those of a wire and gravity. */
    @Override
    public void terms(double[] state, double[] slope, double g, double[] size) {
        for (int i = 0; i < m; i++) {
            partPositions[i] = Math.abs(state[place(i)]);
            size[place(i)] = Math.abs(g * slope[place(i)]);
        }
        if (exact) {
            blocks.getStiffness().applyAbsolute(partPositions, partForces);
        } else {
            forces(partPositions, zero, partForces);
        }
        for (int i = 0; i < m; i++) {
            int at = place(i) + 3;
            size[at] = Math.abs(g) * Math.max(Math.abs(slope[at]), Math.abs(partForces[i]) / blocks.mass(i / 3));
        }
    }
}
