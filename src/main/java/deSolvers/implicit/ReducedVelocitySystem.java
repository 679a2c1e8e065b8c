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
    /**
     * Newton's method needs 5 to 15 iterations for cloth in contact, or it creeps for 40 to 1,000, which cost ten times
     * as much each: twice a shorter step is less work.
     */
    private static final int MOST_IN_CONTACT = 20;
    private static final int MOST_ITERATIONS = 1000;

    private final SolverWork work;
    private final ForceJacobian jacobian;
    private final BlockSolver solver;
    private final Shift real;
    private final Shift complex;
    private final double[][] realRight = new double[1][];
    private final double[][] realSolution = new double[1][];
    private BlockMatrix matrix;
    private final int m;                                // 3 per particle
    private final double[] partPositions;
    private final double[] partVelocities;
    private final double[] partForces;
    private StepTransaction source;

    /** @param n the state's size */
    ReducedVelocitySystem(SolverWork work, int n) {
        this.work = work;
        jacobian = new ForceJacobian(work, n, (state, dSdt) -> source.getStateDerivative(state, dSdt));
        solver = new BlockSolver(work);
        matrix = new BlockMatrix(jacobian.getPattern(), work);
        m = n / 2;
        real = new Shift(1);
        complex = new Shift(2);
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
        if (matrix.getPattern() != jacobian.getPattern()) {
            matrix = new BlockMatrix(jacobian.getPattern(), work);
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

    /**
     * A stiff cloth that begins to buckle needs some hundreds, each of which leads down to lower energy. In contact no
     * energy shows the way.
     */
    @Override
    public int mostIterations() {
        return jacobian.isInContact() ? MOST_IN_CONTACT : MOST_ITERATIONS;
    }

    @Override
    public boolean prepare(double g) {
        real.re = g;
        return solver.prepare(matrix, jacobian.isExact() ? matrix : real, jacobian.combine(g, matrix));
    }

    @Override
    public boolean prepareComplex(double gRe, double gIm) {
        complex.re = gRe;
        complex.im = gIm;
        return true;
    }

    @Override
    public boolean solve(double[] b, double[] x, double tolerance) {
        realRight[0] = b;
        realSolution[0] = x;
        real.reduce(realRight);
        return solver.solve(real.right, real.velocities, tolerance) && real.expand(realRight, realSolution);
    }

    @Override
    public boolean solveComplex(double[][] b, double[][] x, double tolerance) {
        complex.reduce(b);
        return solver.solveComplex(complex, complex.right, complex.velocities, tolerance) && complex.expand(b, x);
    }

    /** The system for one g. A complex vector has all real parts first, then all imaginary ones. */
    private final class Shift implements LinearOperator {
        private double re;                              // of g
        private double im;
        private final double[] right;
        private final double[] velocities;
        private final double[][] forces;                // K b_x, for each part of b

        /** @param parts 1 for a real g, 2 for a complex one */
        Shift(int parts) {
            right = new double[parts * m];
            velocities = new double[parts * m];
            forces = new double[parts][m];
        }

        /** right = M b_v + g K b_x. */
        void reduce(double[][] b) {
            for (int part = 0; part < b.length; part++) {
                for (int i = 0; i < m; i++) {
                    partPositions[i] = b[part][place(i)];
                }
                jacobian.multiply(partPositions, forces[part]);
            }
            for (int part = 0; part < b.length; part++) {
                for (int i = 0; i < m; i++) {
                    right[part * m + i] = jacobian.mass(i / 3) * b[part][place(i) + 3] + re * forces[part][i]
                            + turned(part) * forces[b.length - 1 - part][i];
                }
            }
        }

        /** x_x = b_x + g v and x_v = v; true. */
        boolean expand(double[][] b, double[][] x) {
            for (int part = 0; part < b.length; part++) {
                for (int i = 0; i < m; i++) {
                    double v = velocities[part * m + i];
                    x[part][place(i)] = b[part][place(i)] + re * v + turned(part) * velocities[other(part) + i];
                    x[part][place(i) + 3] = v;
                }
            }
            return true;
        }

        /** i g_im times an imaginary number is real and negative, times a real one imaginary and positive. */
        private double turned(int part) {
            return part == 0 ? -im : im;
        }

        /** Where the other part of a vector begins; a real one has no other, and g_im is 0. */
        private int other(int part) {
            return part == 0 ? velocities.length - m : 0;
        }

        /** y = (M - g C - g<sup>2</sup> K) v; with a real g where the blocks are not the whole Jacobian. */
        @Override
        public void apply(double[] v, double[] y) {
            double squareRe = re * re - im * im;
            for (int part = 0; part * m < v.length; part++) {
                double squareIm = 2 * re * turned(part);
                for (int i = 0; i < m; i++) {
                    double other = v[other(part) + i];
                    partVelocities[i] = re * v[part * m + i] + turned(part) * other;
                    partPositions[i] = squareRe * v[part * m + i] + squareIm * other;
                }
                jacobian.multiply(partPositions, partVelocities, partForces);
                for (int i = 0; i < m; i++) {
                    y[part * m + i] = jacobian.mass(i / 3) * v[part * m + i] - partForces[i];
                }
            }
        }
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
        double[] weight = jacobian.isExact() && !jacobian.isInContact() ? residual : solution;
        double sum = 0;
        for (int i = 0; i < m; i++) {
            sum += jacobian.mass(i / 3) * weight[place(i) + 3] * direction[place(i) + 3];
        }
        return sum;
    }

    /**
     * The accelerations are sums of K x/m, which may cancel; so may those of a wire and gravity. A contact cancels the
     * force that presses its particle on, so each velocity is then given the largest term of all: its round-off may be
     * that large.
     */
    @Override
    public void terms(double[] state, double[] slope, double g, double[] size) {
        for (int i = 0; i < m; i++) {
            partPositions[i] = Math.abs(state[place(i)]);
            size[place(i)] = Math.abs(g * slope[place(i)]);
        }
        jacobian.multiplyAbsolute(partPositions, partForces);
        double largest = 0;
        for (int i = 0; i < m; i++) {
            int at = place(i) + 3;
            size[at] = Math.abs(g) * Math.max(Math.abs(slope[at]), Math.abs(partForces[i]) / jacobian.mass(i / 3));
            largest = Math.max(largest, size[at]);
        }
        for (int i = 0; i < m && jacobian.isInContact(); i++) {
            size[place(i) + 3] = largest;
        }
    }
}
