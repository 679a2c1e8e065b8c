package deSolvers.implicit;

import static deSolvers.implicit.ForceJacobian.place;

import deSolvers.DEStateSource;
import deSolvers.JacobianStateSource;
import deSolvers.StepTransaction;
import deSolvers.linear.BlockMatrix;
import deSolvers.linear.BlockSolver;
import deSolvers.linear.LinearOperator;
import deSolvers.linear.SolverWork;

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
    private final ForceJacobian jacobian;
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
    private final double[] imaginaryForces;
    private final double[] partPositions;
    private final double[] partVelocities;
    private final double[] partForces;
    private StepTransaction source;
    private double g;
    private double gRe;
    private double gIm;

    /** @param n the state's size */
    ReducedVelocitySystem(SolverWork work, int n) {
        this.work = work;
        jacobian = new ForceJacobian(work, n, (state, dSdt) -> source.getStateDerivative(state, dSdt));
        blocks = jacobian.getBlocks();
        solver = new BlockSolver(work);
        matrix = new BlockMatrix(blocks.getPattern(), work);
        m = n / 2;
        realRight = new double[m];
        realVelocities = new double[m];
        right = new double[n];
        velocities = new double[n];
        imaginaryForces = new double[m];
        partPositions = new double[m];
        partVelocities = new double[m];
        partForces = new double[m];
    }

    @Override
    public void setJacobian(StepTransaction source, double[] state, double[] slope, double h, Kind kind) {
        work.jacobians++;
        this.source = source;
        source.setState(state);
        jacobian.setUp((JacobianStateSource) source.getClient(), state, slope, kind != Kind.EXACT);
        if (matrix.getPattern() != blocks.getPattern()) {
            matrix = new BlockMatrix(blocks.getPattern(), work);
        }
    }

    /** Differences belong to the place where they are taken. */
    @Override
    public boolean keepsJacobian() {
        return jacobian.isExact();
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
        return solver.prepare(matrix, jacobian.isExact() ? matrix : products, blocks.combine(g, matrix));
    }

    @Override
    public boolean prepareComplex(double gRe, double gIm) {
        this.gRe = gRe;
        this.gIm = gIm;
        return true;
    }

    @Override
    public boolean solve(double[] b, double[] x, double tolerance) {
        stiffnessTimes(b, 1, 0, partForces);
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
        stiffnessTimes(b, 2, 0, partForces);
        stiffnessTimes(b, 2, 1, imaginaryForces);
        for (int i = 0; i < m; i++) {
            double mass = blocks.mass(i / 3);
            right[i] = mass * b[2 * place(i) + 6] + gRe * partForces[i] - gIm * imaginaryForces[i];
            right[m + i] = mass * b[2 * place(i) + 7] + gRe * imaginaryForces[i] + gIm * partForces[i];
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
        jacobian.multiply(partPositions, partVelocities, y);
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
            jacobian.multiply(partPositions, partVelocities, partForces);
            for (int i = 0; i < m; i++) {
                y[half * m + i] = blocks.mass(i / 3) * v[half * m + i] - partForces[i];
            }
        }
    }

    /** K times positions that stand in a state of one part, or of a real and an imaginary part in turn. */
    private void stiffnessTimes(double[] b, int parts, int part, double[] force) {
        for (int i = 0; i < m; i++) {
            partPositions[i] = b[parts * place(i) + part];
        }
        jacobian.multiply(partPositions, force);
    }

    /**
     * The particles where they are, with velocities of 0. With rods, wires or balls in contact they keep their
     * velocities, as the forces that turn them grow with v&sup2;.
     */
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
     * The power of the forces that are left: the slope of an energy, since positions stay x + g v. The forces of rods,
     * wires, contacts and friction have no energy; for them it is the natural test, whether the next correction still
     * points ahead.
     */
    @Override
    public double slope(double[] residual, double[] solution, double[] direction) {
        double[] weight = jacobian.isExact() ? residual : solution;
        double sum = 0;
        for (int i = 0; i < m; i++) {
            sum += blocks.mass(i / 3) * weight[place(i) + 3] * direction[place(i) + 3];
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
        if (jacobian.isExact()) {
            blocks.getStiffness().applyAbsolute(partPositions, partForces);
        } else {
            jacobian.multiply(partPositions, partForces);
        }
        for (int i = 0; i < m; i++) {
            int at = place(i) + 3;
            size[at] = Math.abs(g) * Math.max(Math.abs(slope[at]), Math.abs(partForces[i]) / blocks.mass(i / 3));
        }
    }
}
