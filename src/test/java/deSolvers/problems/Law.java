package deSolvers.problems;

/** A problem whose law is given as a function. Its exact solution is known at the start only. */
public class Law extends ReferenceProblem {
    private final Rates rates;

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
     * @param start the state at t = 0
     */
    public Law(Rates rates, double... start) {
        super(start);
        this.rates = rates;
    }

    @Override
    protected final void rates(double t, double[] s, double[] dSdt) {
        rates.of(t, s, dSdt);
    }
}
