package deSolvers.problems;

import java.util.function.DoubleFunction;

/** A problem whose law is given as a function, and its exact solution, if it is known. */
public class Law extends ReferenceProblem {
    private final Rates rates;
    private final DoubleFunction<double[]> exact;

    /** The right-hand side f(s, t). */
    public interface Rates {
        /**
         * @param t    the time (s)
         * @param s    the state
         * @param dSdt receives the derivative
         */
        void of(double t, double[] s, double[] dSdt);
    }

    /**
     * @param rates the right-hand side
     * @param start the state at t = 0; no other is known
     */
    public Law(Rates rates, double... start) {
        super(start);
        this.rates = rates;
        exact = super::exactState;
    }

    /**
     * @param rates the right-hand side
     * @param exact the solution at a time; a new array
     */
    public Law(Rates rates, DoubleFunction<double[]> exact) {
        super(exact.apply(0));
        this.rates = rates;
        this.exact = exact;
    }

    @Override
    public double[] exactState(double t) {
        return exact.apply(t);
    }

    @Override
    protected final void rates(double t, double[] s, double[] dSdt) {
        rates.of(t, s, dSdt);
    }
}
