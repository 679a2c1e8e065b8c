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
        for (int block = d; block < s.length; block += 2 * d) {
            for (int v = block; v < block + d; v++) {
                s[v] += h * a[v];
            }
        }
    }

    /** x += h v. */
    final void drift(double[] s, double h) {
        for (int block = 0; block < s.length; block += 2 * d) {
            for (int x = block; x < block + d; x++) {
                s[x] += h * s[x + d];
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
            implicitKick.solve(s, guess, h, a);
            return a;
        }
        double[] a = derivative(s);
        kick(s, a, h);
        return a;
    }

    /**
     * A kick with the acceleration at its own end, v = v0 + h a(x, v, t), solved for v by fixed-point iteration. With
     * the acceleration at v0 instead, a step would no longer be the mirror image of itself, and its order would fall to
     * 1.
     */
    private final class ImplicitKick {
        /** Relative to the velocities: some hundred times the round-off. */
        private static final double TOLERANCE = 1e-13;
        /** Relative to the largest position: how far round-off may move the end of the step. */
        private static final double ROUND_OFF = 0x1p-50;
        private static final int MOST_ITERATIONS = 100;

        private double[] before = {};                       // (x, v0)
        private double change;                              // the largest change of a velocity in the last iteration

        /**
         * Solves the equation.
         *
         * @param s     holds (x, v0); receives (x, v)
         * @param guess an acceleration nearby
         * @param h     the kick's length (s)
         * @param a     receives the acceleration at (x, v)
         */
        void solve(double[] s, double[] guess, double h, double[] a) {
            if (before.length != s.length) {
                before = new double[s.length];
            }
            System.arraycopy(s, 0, before, 0, s.length);
            kick(s, guess, h);
            double scale = largest(before, d);
            for (int iteration = 0; iteration < MOST_ITERATIONS; iteration++) {
                double last = change;
                getTransaction().getStateDerivative(s, a);      // at (x, v, t) with the latest v
                kick(s, a, h);
                if (iteration == 0) {
                    getTransaction().requireFinite(a);
                    scale += change;
                }
                if (!(change <= Double.MAX_VALUE)) {
                    break;                              // diverged until the source overflows: not the source's fault
                }
                if (change <= TOLERANCE * Math.max(scale, Double.MIN_NORMAL)) { // smaller numbers have fewer digits
                    return;
                }
                if (iteration > 0 && change >= last
                        && change * Math.abs(h) <= ROUND_OFF * largest(s, 0)) {
                    return;                             // near rest, where large forces cancel, only round-off is left
                }
            }
            throw getTransaction().failure(-1, "the velocity at the end of the step did not converge in "
                    + MOST_ITERATIONS + " iterations", "the last change is " + change + " of " + scale
                    + "; drag or spring damping is too stiff for this deltaT:"
                    + " take a smaller one or an implicit solver");
        }

        /** v = v0 + h a; notes the largest change, NaN if one is. */
        private void kick(double[] s, double[] a, double h) {
            double largest = 0;
            for (int block = d; block < s.length; block += 2 * d) {
                for (int v = block; v < block + d; v++) {
                    double kicked = before[v] + h * a[v];
                    largest = Math.max(largest, Math.abs(kicked - s[v]));
                    s[v] = kicked;
                }
            }
            change = largest;
        }

        /** The largest size among the positions, from entry 0 on, or the velocities, from entry d on; NaN if one is. */
        private double largest(double[] s, int first) {
            double largest = 0;
            for (int block = first; block < s.length; block += 2 * d) {
                for (int i = block; i < block + d; i++) {
                    largest = Math.max(largest, Math.abs(s[i]));
                }
            }
            return largest;
        }
    }
}
