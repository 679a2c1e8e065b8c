package deSolvers.implicit;

import deSolvers.JacobianStateSource;
import deSolvers.StepTransaction;
import deSolvers.linear.BlockJacobi;
import deSolvers.linear.BlockMatrix;
import deSolvers.linear.BlockPattern;
import deSolvers.linear.ConjugateGradients;
import deSolvers.linear.FrontalFactors;
import deSolvers.linear.Gmres;
import deSolvers.linear.ImplicitWork;
import deSolvers.linear.LinearOperator;

/**
 * The stage equation of particles in space, with the velocities as the only unknowns: since the stage's positions are
 * x + g v, what is left is M (v - v<sub>0</sub>) = g F(x<sub>0</sub> + g v, v), with the sparse matrix
 * M - g dF/dv - g<sup>2</sup> dF/dx.
 */
final class ReducedVelocityProblem implements NewtonProblem, LinearOperator {
    /** Up to here a factorisation costs next to nothing and is the most robust. */
    private static final int SMALL = 64;
    /** Conjugate gradients take about so many iterations for eight digits, times the root of the condition. */
    private static final double ITERATIONS = 6.5;
    /** Nobody looks for a cheaper way than so many iterations. */
    private static final double FEW_ITERATIONS = 30;
    /**
     * Factors of more blocks than this (of 72 bytes) are not made; it is the memory for them that ends at some size.
     */
    static final long MOST_BLOCKS = 4_000_000;
    private static final int MOST_GMRES_ITERATIONS = 2000;
    private static final double ROUNDING = 2 * Math.ulp(1.0);

    private final ImplicitWork.Counter work;
    private final BlockMatrix matrix;
    private final BlockJacobi blockJacobi;
    private final FrontalFactors factors;
    private final ConjugateGradients conjugateGradients;
    private final Gmres gmres;
    private StepTransaction source;
    private JacobianStateSource client;
    private double[] start;
    private double gamma;
    private double linearTolerance;
    private double[] masses = {};
    private double[] stage = {};
    private double[] dSdt = {};
    private double[] base = {};
    private double[] direction = {};
    private double[] product = {};
    private double[] image = {};
    private boolean exactBlocks;
    private boolean clamped;
    private boolean factorised;
    private boolean regular;

    ReducedVelocityProblem(ImplicitWork.Counter work) {
        this.work = work;
        matrix = new BlockMatrix(work);
        blockJacobi = new BlockJacobi(work);
        factors = new FrontalFactors(work);
        conjugateGradients = new ConjugateGradients(work);
        gmres = new Gmres(work);
    }

    /** Takes up the equation of one step; {@code start} is read as long as it is worked on. */
    void begin(StepTransaction source, JacobianStateSource client, double[] start, double gamma,
            double linearTolerance) {
        this.source = source;
        this.client = client;
        this.start = start;
        this.gamma = gamma;
        this.linearTolerance = linearTolerance;
        exactBlocks = client.getJacobianBlocks() == JacobianStateSource.Blocks.EXACT;
        int n = start.length;
        if (stage.length != n) {
            masses = new double[n / 6];
            stage = new double[n];
            dSdt = new double[n];
            base = new double[n];
            direction = new double[n];
            product = new double[n];
            image = new double[n / 2];
        }
        for (int i = 0; i < masses.length; i++) {
            double inverseMass = client.getInverseMass(i);
            masses[i] = inverseMass == 0 ? 0 : 1 / inverseMass;
        }
    }

    @Override
    public int size() {
        return start.length / 2;
    }

    /** The velocities of the step's start. */
    void startVelocities(double[] v) {
        for (int i = 0; i < masses.length; i++) {
            System.arraycopy(start, 6 * i + 3, v, 3 * i, 3);
        }
    }

    /** The stage (x0 + g v, v). */
    void stage(double[] v, double[] stage) {
        for (int i = 0, at = 0; at < v.length; i += 6, at += 3) {
            for (int c = 0; c < 3; c++) {
                stage[i + c] = start[i + c] + gamma * v[at + c];
                stage[i + c + 3] = v[at + c];
            }
        }
    }

    @Override
    public void evaluate(double[] v, double[] residual) {
        stage(v, stage);
        source.setState(stage);
        source.getStateDerivative(dSdt);
        for (int i = 0; i < masses.length; i++) {
            double mass = masses[i] == 0 ? 1 : masses[i];
            for (int c = 0; c < 3; c++) {
                residual[3 * i + c] = mass * (start[6 * i + 3 + c] - v[3 * i + c] + gamma * dSdt[6 * i + 3 + c]);
            }
        }
    }

    @Override
    public void linearise(double[] v) {
        collect(v, false);
    }

    @Override
    public boolean lineariseDefinite(double[] v) {
        collect(v, true);
        return regular;
    }

    private void collect(double[] v, boolean definite) {
        clamped = definite;
        stage(v, base);
        source.setState(base);
        matrix.collect(client, base, gamma, masses, definite);
        factorised = false;
        if (masses.length <= SMALL || factorsPay()) {
            factorise();
        }
        regular = factorised || blockJacobi.prepare(matrix.pattern(), matrix.values());
    }

    /** Whether factors would take less work than iterations. */
    private boolean factorsPay() {
        BlockPattern pattern = matrix.pattern();
        double iterations = ITERATIONS * Math.sqrt(matrix.condition());
        return iterations > FEW_ITERATIONS && factors.fits(pattern, MOST_BLOCKS)
                && factors.work(matrix.isSymmetric()) < iterations * (pattern.blocks() + pattern.rows);
    }

    private void factorise() {
        factorised = factors.fits(matrix.pattern(), MOST_BLOCKS) && factors.factorise(matrix.values(),
                matrix.isSymmetric());
    }

    @Override
    public boolean correct(double[] residual, double[] correction) {
        if (!exactBlocks) {
            source.setState(base);                      // where the products are asked for
        }
        LinearOperator operator = exactBlocks || clamped ? matrix : this;
        if (!factorised && regular) {
            if ((exactBlocks || clamped) && matrix.isSymmetric() && conjugateGradients(residual, correction)) {
                return true;
            }
            if (gmres.solve(operator, blockJacobi, residual, correction, linearTolerance, MOST_GMRES_ITERATIONS)) {
                return true;
            }
        }
        if (!factorised) {
            factorise();
        }
        return factorised && (operator == matrix && eliminate(residual, correction)
                || gmres.solve(operator, factors, residual, correction, linearTolerance, MOST_GMRES_ITERATIONS));
    }

    /** Whether the factors alone, used once, are accurate enough. */
    private boolean eliminate(double[] residual, double[] correction) {
        factors.apply(residual, correction);
        matrix.apply(correction, image);
        double left = 0;
        for (int i = 0; i < image.length; i++) {
            double rest = residual[i] - image[i];
            left += rest * rest;
        }
        return Math.sqrt(left) <= linearTolerance * Gmres.norm(residual);
    }

    /**
     * Begins with held particles where they have to be: the iteration then never sees their columns, and stays
     * symmetric.
     */
    private boolean conjugateGradients(double[] residual, double[] correction) {
        for (int i = 0; i < correction.length; i++) {
            correction[i] = masses[i / 3] == 0 ? residual[i] : 0;
        }
        int mostIterations = (int) (100 + 20 * Math.sqrt(matrix.condition()));
        return conjugateGradients.solve(matrix, blockJacobi, residual, correction, linearTolerance, mostIterations);
    }

    /** y = M (x - g J (g x, x)), by the source's own product: where its blocks are not the whole Jacobian. */
    @Override
    public void apply(double[] x, double[] y) {
        for (int i = 0; i < masses.length; i++) {
            for (int c = 0; c < 3; c++) {
                direction[6 * i + c] = gamma * x[3 * i + c];
                direction[6 * i + 3 + c] = x[3 * i + c];
            }
        }
        work.products++;
        client.getJacobianProduct(direction, product);
        for (int i = 0; i < masses.length; i++) {
            double mass = masses[i] == 0 ? 1 : masses[i];
            for (int c = 0; c < 3; c++) {
                y[3 * i + c] = mass * (x[3 * i + c] - gamma * product[6 * i + 3 + c]);
            }
        }
    }

    @Override
    public void rounding(double[] v, double[] floor) {
        double[] forceScale = matrix.forceScale();
        for (int i = 0; i < v.length; i++) {
            int at = 6 * (i / 3) + 3 + i % 3;
            double mass = masses[i / 3] == 0 ? 1 : masses[i / 3];
            floor[i] = Double.MIN_NORMAL + ROUNDING * (mass * (Math.abs(start[at]) + Math.abs(v[i]))
                    + Math.abs(gamma) * forceScale[i]);
        }
    }
}
