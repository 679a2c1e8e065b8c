package deSolvers;

/**
 * Base class of fixed-step solvers, which make one step of length deltaT. A subclass implements only {@link #step}, the
 * formula on the slide; this class follows the other rules of {@link DESolver}.
 *
 * <p>The helpers read like the formulas:
 * <pre>
 *   derivative(s)          f(s, t), where t is the source's clock
 *   eulerStep(s, deltaT)   deltaT f(s, t)
 *   plus(s, 0.5, k)        s + 0.5 k
 * </pre>
 * Each call returns a separate work array, valid until the end of the step.
 */
public abstract class FixedStepSolver extends DESolver {
    private final StepTransaction transaction = new StepTransaction(getClass());
    private final WorkArrays arrays = new WorkArrays();
    private final LastStep lastStep = new LastStep();
    private boolean asksForLastStep;

    /**
     * Makes the step.
     *
     * @param source stands at the start (s, t); its clock may be moved, to evaluate at other times
     * @param s      holds s(t), and receives s(t + deltaT); length n
     * @param deltaT the time step (s), not 0
     */
    protected abstract void step(DEStateSource source, double[] s, double deltaT);

    /**
     * Reads the state, calls {@link #step}, writes the new state and sets the clock to t + deltaT. If anything fails,
     * the {@link StepTransaction} puts back the state and the time that it found.
     */
    @Override
    public final void stepState(DEStateSource source, double deltaT) {
        try (StepTransaction guarded = transaction.begin(source, deltaT)) {     // guarded stands for the source
            double[] s = arrays.first(source.getStateSize());
            source.getState(s);
            if (deltaT != 0) {
                step(guarded, s, deltaT);
                if (asksForLastStep) {
                    lastStep.keep(guarded, s);
                }
            }
            guarded.finish(s);
        }
    }

    /**
     * Evaluates the derivative at a state and the source's present time.
     *
     * @param s a state; length n
     * @return f(s, t); length n
     * @throws DESolverException if an entry is not finite
     */
    protected final double[] derivative(double[] s) {
        double[] dSdt = arrays.next();
        transaction.getStateDerivative(s, dSdt);
        transaction.requireFinite(dSdt);
        return dSdt;
    }

    /**
     * Computes the increment of an Euler step, deltaT times the derivative at a state and the source's present time.
     *
     * @param s      a state; length n
     * @param deltaT a time step (s)
     * @return deltaT f(s, t); length n
     * @throws DESolverException if an entry of the derivative is not finite
     */
    protected final double[] eulerStep(double[] s, double deltaT) {
        double[] k = derivative(s);
        for (int i = 0; i < k.length; i++) {
            k[i] *= deltaT;
        }
        return k;
    }

    /**
     * Adds a multiple of an increment to a state.
     *
     * @param s      a state; length n
     * @param factor the multiple
     * @param k      an increment of the state; length n
     * @return s + factor k; length n
     */
    protected final double[] plus(double[] s, double factor, double[] k) {
        double[] sum = arrays.next();
        for (int i = 0; i < sum.length; i++) {
            sum[i] = s[i] + factor * k[i];
        }
        return sum;
    }

    /**
     * Copies an array.
     *
     * @param a an array; length n
     * @return a copy of it
     */
    protected final double[] copy(double[] a) {
        double[] copy = arrays.next();
        System.arraycopy(a, 0, copy, 0, copy.length);
        return copy;
    }

    /**
     * Tells whether this step begins exactly where this solver's last one ended: with the same source, state, time and
     * deltaT, bit for bit. Only then may a method use its memory of the last step. Call it once in every step.
     *
     * @return true if it does; false in the first step, after {@link #reset} and after a step that failed
     */
    protected final boolean continuesLastStep() {
        asksForLastStep = true;
        return lastStep.continuesFrom(transaction);
    }

    /** @return the step that is being made, for solvers that need a Jacobian or another interface of the source */
    protected final StepTransaction getTransaction() {
        return transaction;
    }

    @Override
    public final void reset() {
        lastStep.forget();
    }
}
