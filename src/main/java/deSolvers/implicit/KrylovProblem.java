package deSolvers.implicit;

import deSolvers.StepTransaction;
import deSolvers.linear.Gmres;
import deSolvers.linear.ImplicitWork;
import deSolvers.linear.LinearOperator;
import java.util.Arrays;
import java.util.Random;

/**
 * The stage equation m = s + g f(m) of a large source of any kind: Newton-Krylov without a matrix. GMRES needs nothing
 * but products J w, which the source computes or one difference of derivatives approximates.
 *
 * <p>Source: D. A. Knoll, D. E. Keyes (2004), J. Comput. Phys. 193, 357.
 */
final class KrylovProblem implements NewtonProblem, LinearOperator {
    private static final int MOST_ITERATIONS = 2000;
    private static final double ROUNDING = 2 * Math.ulp(1.0);
    /**
     * Of the largest entry: what GMRES, which gains four digits a time on all together, is not asked to find among the
     * rest.
     */
    private static final double SMALLEST = 1e-28;

    private final ImplicitWork.Counter work;
    private final Gmres gmres;
    private final DirectionalDerivative derivative;
    private final Random random = new Random();
    private StepTransaction source;
    private double[] start;
    private double gamma;
    private double linearTolerance;
    private double[] dSdt = {};
    private double[] mixed = {};
    private double[] product = {};
    private double[] productScale = {};                 // of the terms of J m; 0 where it has not been asked for
    private double[] spread = {};                       // of the rounding of the entries by J, as long
    private double[] rounding = {};

    KrylovProblem(ImplicitWork.Counter work) {
        this.work = work;
        gmres = new Gmres(work);
        derivative = new DirectionalDerivative(work);
    }

    /** Takes up the equation of one step; {@code start} is read as long as it is worked on. */
    void begin(StepTransaction source, double[] start, double gamma, double linearTolerance) {
        this.source = source;
        this.start = start;
        this.gamma = gamma;
        this.linearTolerance = linearTolerance;
        if (dSdt.length != start.length) {
            dSdt = new double[start.length];
            mixed = new double[start.length];
            product = new double[start.length];
            productScale = new double[start.length];
            spread = new double[start.length];
            rounding = new double[start.length];
        }
        derivative.setFine(false);
        Arrays.fill(productScale, 0);
        Arrays.fill(spread, 0);
    }

    @Override
    public int size() {
        return start.length;
    }

    @Override
    public void evaluate(double[] m, double[] residual) {
        source.setState(m);
        source.getStateDerivative(dSdt);
        for (int i = 0; i < m.length; i++) {
            residual[i] = start[i] - m[i] + gamma * dSdt[i];
        }
    }

    @Override
    public void linearise(double[] m) {
        work.jacobians++;
        derivative.setBase(source, m, dSdt, gamma);
    }

    @Override
    public boolean correct(double[] residual, double[] correction) {
        return gmres.solve(this, LinearOperator.IDENTITY, residual, correction, linearTolerance, MOST_ITERATIONS);
    }

    /** y = x - g J x. */
    @Override
    public void apply(double[] x, double[] y) {
        derivative.multiply(x, y);
        for (int i = 0; i < x.length; i++) {
            y[i] = x[i] - gamma * y[i];
        }
    }

    /** Without a matrix only the rounding of the sum itself is known, and after {@link #refine} about that of f. */
    @Override
    public void rounding(double[] m, double[] floor) {
        double smallest = Double.MIN_NORMAL + SMALLEST * NewtonUpdate.largest(m);
        for (int i = 0; i < m.length; i++) {
            floor[i] = smallest + ROUNDING * (Math.abs(start[i]) + Math.abs(m[i])
                    + Math.abs(gamma) * Math.max(Math.abs(dSdt[i]), productScale[i])) + Math.abs(gamma) * spread[i];
        }
    }

    /**
     * How large the terms are that cancel in f is told by products of J with m, each entry times a random number. An
     * entry is known no better than the rounding of its own equation, which the same products spread to the others.
     */
    @Override
    public void refine(double[] m) {
        derivative.setFine(true);
        derivative.setBase(source, m, dSdt, gamma);
        addProducts(m, productScale);
        rounding(m, rounding);
        addProducts(rounding, spread);
    }

    /** Random numbers let three products be less than a hundredth of their terms in one row of a million. */
    private void addProducts(double[] sizes, double[] largest) {
        random.setSeed(sizes.length);                   // so that a step can be repeated bit for bit
        for (int attempt = 0; attempt < 3; attempt++) {
            for (int i = 0; i < sizes.length; i++) {
                mixed[i] = (2 * random.nextDouble() - 1) * sizes[i];
            }
            derivative.multiply(mixed, product);
            for (int i = 0; i < sizes.length; i++) {
                largest[i] = Math.max(largest[i], Math.abs(product[i]));
            }
        }
    }
}
