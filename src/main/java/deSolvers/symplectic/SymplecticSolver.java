package deSolvers.symplectic;

import deSolvers.DEStateSource;
import deSolvers.FixedStepSolver;
import deSolvers.LastStep;
import deSolvers.SecondOrderStateSource;

/**
 * Base class of symplectic methods, which move positions and velocities in turn. A state has the blocks (x1, v1, x2,
 * v2, ...) of a {@link SecondOrderStateSource}; an array of accelerations holds them in the velocities' entries, as
 * ds/dt does.
 */
abstract class SymplecticSolver extends FixedStepSolver {
    private final ImplicitKick implicitKick = new ImplicitKick();
    private final LastStep lastStep = new LastStep();
    private double[] remembered = {};                   // the acceleration where it ended
    private int d;

    /**
     * Makes the step, as {@link FixedStepSolver#step}.
     *
     * @param source stands at the start; its clock may be moved
     * @param s      holds (x, v) at t, and receives (x, v) at t + deltaT
     * @param deltaT the time step (s)
     */
    abstract void kickAndDrift(DEStateSource source, double[] s, double deltaT);

    @Override
    protected final void step(DEStateSource source, double[] s, double deltaT) {
        int dimension = secondOrder().getDimension();
        if (d != dimension || remembered.length != s.length) {
            d = dimension;
            remembered = new double[s.length];
            requireBlocks(s.length);
        }
        kickAndDrift(source, s, deltaT);
    }

    /** The client as a second-order source; an exception names the missing type. */
    private SecondOrderStateSource secondOrder() {
        DEStateSource client = getTransaction().getClient();
        if (!(client instanceof SecondOrderStateSource)) {
            throw new IllegalArgumentException(getClass().getSimpleName() + " moves positions and velocities in"
                    + " turn and needs a " + SecondOrderStateSource.class.getName() + "; " + client.getClass().getName()
                    + " is only a " + DEStateSource.class.getName());
        }
        return (SecondOrderStateSource) client;
    }

    private void requireBlocks(int n) {
        if (d < 1 || n % (2 * d) != 0) {
            throw new IllegalArgumentException(getTransaction().getClient().getClass().getName() + " has dimension " + d
                    + " and " + n
                    + " state entries; the state has to be made of blocks of d positions and d velocities, d >= 1");
        }
    }

    /**
     * The acceleration at the start: the remembered one where this step continues the last, which saves an evaluation.
     */
    final double[] startAcceleration(double[] s) {
        return lastStep.continuesFrom(getTransaction()) ? remembered : derivative(s);
    }

    /** Keeps the acceleration a at the end of the step, where the state is s, for the next step. */
    final void remember(double[] s, double[] a) {
        System.arraycopy(a, 0, remembered, 0, a.length);
        lastStep.keep(getTransaction(), s);
    }

    @Override
    public final void reset() {
        lastStep.forget();
    }

    /** v += h a. */
    final void kick(double[] s, double[] a, double h) {
        add(s, d, h, a);
    }

    /** x += h v. */
    final void drift(double[] s, double h) {
        add(s, 0, h, s);
    }

    /** In each block, adds h times the last d entries of the rates to d entries of s, from the first one on. */
    private void add(double[] s, int first, double h, double[] rates) {
        if (d == 3) {                                   // written out: an inner loop takes three times as long
            for (int i = first, v = 3; v < s.length; i += 6, v += 6) {
                s[i] += h * rates[v];
                s[i + 1] += h * rates[v + 1];
                s[i + 2] += h * rates[v + 2];
            }
            return;
        }
        for (int i = first, v = d; v < s.length; i += 2 * d, v += 2 * d) {
            for (int c = 0; c < d; c++) {
                s[i + c] += h * rates[v + c];
            }
        }
    }

    /**
     * The kick that ends a leapfrog, v += h a(x, v, t) with the acceleration at the new state. If the acceleration
     * depends on v, this is an equation for v.
     *
     * @param s     holds the new x and the old v; receives the new v
     * @param guess an acceleration nearby, for the equation's first guess
     * @param h     the kick's length (s)
     * @return the acceleration at the new state
     */
    final double[] closingKick(double[] s, double[] guess, double h) {
        if (secondOrder().accelerationDependsOnVelocity()) {
            double[] a = copy(guess);
            implicitKick.solve(getTransaction(), s, guess, d, h, a);
            return a;
        }
        double[] a = derivative(s);
        kick(s, a, h);
        return a;
    }
}
