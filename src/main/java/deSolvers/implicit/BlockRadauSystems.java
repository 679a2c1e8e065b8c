package deSolvers.implicit;

import deSolvers.JacobianStateSource;
import deSolvers.StepTransaction;
import deSolvers.linear.BlockJacobi;
import deSolvers.linear.BlockPattern;
import deSolvers.linear.ForceBlocks;
import deSolvers.linear.FrontalFactors;
import deSolvers.linear.Gmres;
import deSolvers.linear.ImplicitWork;
import deSolvers.linear.LinearOperator;
import java.util.Arrays;

/**
 * The systems of particles in space that offer the 3 x 3 blocks of their force derivatives. With x = (p, w), the
 * positions' and the velocities' part, the first half of (mu - h J) x = b gives p = (b<sub>p</sub> + h w)/mu, and the
 * second <blockquote>
 * A w = (M b<sub>w</sub> + g K b<sub>p</sub>)/mu with A = M - g C - g<sup>2</sup> K, g = h/mu,
 * </blockquote>
 * for the real mu and for the complex one alike. GMRES solves it, for both with one preconditioner that is made for the
 * real mu: the diagonal blocks while the springs, seen through the sub-step, are not much stiffer than inertia;
 * otherwise the factors of the sparse matrix. These solve the real system at once. In the complex one they leave
 * eigenvalues between 1 and (mu/mu<sub>complex</sub>)<sup>2</sup> for what oscillates, 1 and mu/mu<sub>complex</sub>
 * for what decays, with moduli from 0.6 to 1 however stiff it is: each iteration halves what is left. Old factors are
 * kept until what they cost in iterations more than when they were new would have paid for new ones.
 */
final class BlockRadauSystems implements RadauSystems {
    /**
     * A hundredth of what a correction has to be good for, so that Newton's iteration converges as with exact
     * solutions.
     */
    private static final double TOLERANCE = 1e-4;
    private static final int MOST_ITERATIONS = 1000;
    /** Factors are too old when the sub-step has changed this much. */
    private static final double MOST_CHANGE = 2;

    private final ImplicitWork.Counter work;
    private final ForceBlocks blocks;
    private final FrontalFactors factors;
    private final BlockJacobi blockJacobi;
    private final DirectionalDerivative derivative;
    private final Gmres realGmres;
    private final Gmres complexGmres;
    private final LinearOperator real = this::applyReal;
    private final LinearOperator complex = this::applyComplex;
    private final LinearOperator complexInverse = this::applyComplexInverse;
    private LinearOperator inverse;                     // of A for the real mu, or of its diagonal blocks
    private double[] values = {};
    private final int m;                                // 3 a particle
    private final double[] positions;                   // real parts first, then imaginary ones
    private final double[] velocities;
    private final double[] right;
    private final double[] part;
    private final double[] partPositions;
    private final double[] partVelocities;
    private final double[] partForces;
    private final double[] realRight;
    private final double[] realVelocities;
    private final double[] direction;
    private final double[] product;
    private StepTransaction source;
    private double offset;
    private boolean exact;
    private double h;
    private double mu;
    private double gRe;                                 // h / complex mu
    private double gIm;
    private double factorisedFor;                       // g of the factors, 0 if there are none
    private long iterationsWhenNew;
    private double debt;                                // block operations that old factors have cost

    BlockRadauSystems(ImplicitWork.Counter work, int n) {
        this.work = work;
        blocks = new ForceBlocks(work);
        factors = new FrontalFactors(work);
        blockJacobi = new BlockJacobi(work);
        derivative = new DirectionalDerivative(work);
        realGmres = new Gmres(work);
        complexGmres = new Gmres(work);
        inverse = blockJacobi;
        m = n / 2;
        positions = new double[n];
        velocities = new double[n];
        right = new double[n];
        part = new double[m];
        partPositions = new double[m];
        partVelocities = new double[m];
        partForces = new double[m];
        realRight = new double[m];
        realVelocities = new double[m];
        direction = new double[n];
        product = new double[n];
    }

    @Override
    public void setJacobian(StepTransaction source, double[] state, double[] slope, double offset, double h) {
        this.source = source;
        this.offset = offset;
        JacobianStateSource client = (JacobianStateSource) source.getClient();
        exact = client.getJacobianBlocks() == JacobianStateSource.Blocks.EXACT;
        derivative.setBase(source, state, slope, h);
        source.setState(state);
        source.setOffset(offset);
        BlockPattern before = blocks.pattern();
        blocks.collect(client, m / 3);
        if (blocks.pattern() != before) {
            values = new double[9 * blocks.pattern().blocks()];
            factorisedFor = 0;
        }
    }

    /** Products by the source itself are taken where it is, and anew with each sub-step. */
    @Override
    public boolean keepsJacobian() {
        return exact;
    }

    @Override
    public boolean prepare(double h, double mu, double muRe, double muIm) {
        this.h = h;
        this.mu = mu;
        double square = muRe * muRe + muIm * muIm;
        gRe = h * muRe / square;
        gIm = -h * muIm / square;
        double condition = blocks.combine(h / mu, values);
        if (Math.sqrt(condition) > costOfFactors() && (usable(h / mu) || factorise(h / mu))) {
            inverse = factors;
            return true;
        }
        inverse = blockJacobi;
        return blockJacobi.prepare(blocks.pattern(), values);
    }

    /**
     * How many times more an iteration with factors costs than one with the diagonal blocks, of which about the root of
     * the condition are needed for one; infinite where factors would be too large.
     */
    private double costOfFactors() {
        boolean fits = factors.fits(blocks.pattern(), ReducedVelocityProblem.MOST_BLOCKS);
        return fits ? 1 + factors.blocks() / (2.0 * blocks.pattern().blocks()) : Double.POSITIVE_INFINITY;
    }

    private boolean usable(double g) {
        double change = g / factorisedFor;
        return factorisedFor != 0 && change < MOST_CHANGE && change > 1 / MOST_CHANGE && debt < factors.cost();
    }

    private boolean factorise(double g) {
        debt = 0;
        iterationsWhenNew = 0;
        factorisedFor = factors.factorise(values, false) ? g : 0;
        return factorisedFor != 0;
    }

    @Override
    public boolean solveReal(double[] b, double[] x) {
        for (int i = 0; i < m; i++) {
            partPositions[i] = b[place(i)];
        }
        Arrays.fill(partVelocities, 0);
        forces(partPositions, partVelocities, partForces);
        for (int i = 0; i < m; i++) {
            realRight[i] = (blocks.mass(i / 3) * b[place(i) + 3] + h / mu * partForces[i]) / mu;
        }
        if (!realGmres.solve(real, inverse, realRight, realVelocities, TOLERANCE, MOST_ITERATIONS)) {
            factorisedFor = 0;
            return false;
        }
        for (int i = 0; i < m; i++) {
            x[place(i)] = (b[place(i)] + h * realVelocities[i]) / mu;
            x[place(i) + 3] = realVelocities[i];
        }
        return true;
    }

    @Override
    public boolean solveComplex(double[] b, double[] x) {
        for (int half = 0; half < 2; half++) {
            for (int i = 0; i < m; i++) {
                partPositions[i] = b[2 * place(i) + half];
            }
            Arrays.fill(partVelocities, 0);
            System.arraycopy(partPositions, 0, positions, half * m, m);
            forces(partPositions, partVelocities, partForces);
            System.arraycopy(partForces, 0, velocities, half * m, m);
        }
        double toRe = gRe / h;                          // 1 / complex mu
        double toIm = gIm / h;
        for (int i = 0; i < m; i++) {
            double mass = blocks.mass(i / 3);
            double re = mass * b[2 * place(i) + 6] + gRe * velocities[i] - gIm * velocities[m + i];
            double im = mass * b[2 * place(i) + 7] + gRe * velocities[m + i] + gIm * velocities[i];
            right[i] = toRe * re - toIm * im;
            right[m + i] = toRe * im + toIm * re;
        }
        long before = work.krylovIterations;
        boolean solved = complexGmres.solve(complex, complexInverse, right, velocities, TOLERANCE, MOST_ITERATIONS);
        if (!solved) {
            factorisedFor = 0;
            return false;
        }
        note(work.krylovIterations - before);
        for (int i = 0; i < m; i++) {
            double re = positions[i] + h * velocities[i];
            double im = positions[m + i] + h * velocities[m + i];
            int at = 2 * place(i);
            x[at] = toRe * re - toIm * im;
            x[at + 1] = toRe * im + toIm * re;
            x[at + 6] = velocities[i];
            x[at + 7] = velocities[m + i];
        }
        return true;
    }

    /** Adds up what old factors cost. */
    private void note(long iterations) {
        if (inverse == factors && iterationsWhenNew == 0) {
            iterationsWhenNew = iterations;
        } else if (inverse == factors) {
            debt += 2.0 * Math.max(0,
                    iterations - iterationsWhenNew) * (factors.blocks() + 2 * blocks.pattern().blocks());
        }
    }

    /** y = A x = M x - K (g^2 x) - C (g x) for the real mu. */
    private void applyReal(double[] x, double[] y) {
        double g = h / mu;
        for (int i = 0; i < m; i++) {
            partVelocities[i] = g * x[i];
            partPositions[i] = g * partVelocities[i];
        }
        forces(partPositions, partVelocities, y);
        for (int i = 0; i < m; i++) {
            y[i] = blocks.mass(i / 3) * x[i] - y[i];
        }
    }

    /** The same for the complex mu, whose g makes real and imaginary parts act on each other; K and C are real. */
    private void applyComplex(double[] x, double[] y) {
        double squareRe = gRe * gRe - gIm * gIm;
        double squareIm = 2 * gRe * gIm;
        for (int half = 0; half < 2; half++) {
            int other = half == 0 ? m : 0;
            double sign = half == 0 ? -1 : 1;
            for (int i = 0; i < m; i++) {
                partVelocities[i] = gRe * x[half * m + i] + sign * gIm * x[other + i];
                partPositions[i] = squareRe * x[half * m + i] + sign * squareIm * x[other + i];
            }
            forces(partPositions, partVelocities, partForces);
            for (int i = 0; i < m; i++) {
                y[half * m + i] = blocks.mass(i / 3) * x[half * m + i] - partForces[i];
            }
        }
    }

    private void applyComplexInverse(double[] x, double[] y) {
        for (int half = 0; half < 2; half++) {
            System.arraycopy(x, half * m, part, 0, m);
            inverse.apply(part, partForces);
            System.arraycopy(partForces, 0, y, half * m, m);
        }
    }

    /** K p + C w: block by block, or by the source's own product where its blocks are not the whole Jacobian. */
    private void forces(double[] p, double[] w, double[] force) {
        if (exact) {
            blocks.apply(p, w, force);
            return;
        }
        for (int i = 0; i < m; i++) {
            direction[place(i)] = p[i];
            direction[place(i) + 3] = w[i];
        }
        source.setOffset(offset);
        derivative.multiply(direction, product);
        for (int i = 0; i < m; i++) {
            force[i] = blocks.mass(i / 3) * product[place(i) + 3];
        }
    }

    /** Where coordinate i of all particles' stands in the state; that of its velocity is 3 further on. */
    private static int place(int i) {
        return 6 * (i / 3) + i % 3;
    }
}
