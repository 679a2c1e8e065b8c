package deSolvers;

/**
 * A method that takes one step of deltaT: a subclass writes only {@link #step}, the formula of the slide. This class
 * keeps the contract of {@link DESolver} around it: the start state is kept and put back after an exception, the new
 * state is checked and handed to the source, and the clock ends at exactly t + deltaT.
 *
 * <p>The helpers read as the slides' formulas do:
 * <pre>
 *   derivative(s)          ds/dt at (s, t), where t is the source's clock
 *   times(deltaT, a)       deltaT a
 *   plus(s, k, 0.5)        s + 0.5 k
 * </pre>
 * Every call returns an array that no other result of the same step shares. The arrays are lent for one step: the next
 * step uses them again.
 */
public abstract class FixedStepSolver extends DESolver {
    private final StepTransaction transaction = new StepTransaction(this);
    private final WorkArrays arrays = new WorkArrays();
    private final LastStep lastStep = new LastStep();
    private boolean remembering;                        // whether the method asks for the last step

    /**
     * Makes the step.
     *
     * @param source stands at the start (s, t); its clock may be moved to evaluate at other times
     * @param s      holds s(t), and receives s(t + deltaT); n long
     * @param deltaT the time step (s), not 0
     */
    protected abstract void step(DEStateSource source, double[] s, double deltaT);

    @Override
    public final void stepState(DEStateSource source, double deltaT) {
        try (StepTransaction step = transaction.begin(source, deltaT)) {
            arrays.begin(source.getStateSize());
            double[] s = arrays.next();
            source.getState(s);
            if (deltaT != 0) {
                step(step, s, deltaT);
                if (remembering) {
                    lastStep.keep(step, s);
                }
            }
            double[] free = step.finish(s);
            if (free != s) {
                arrays.replaceFirst(free);
            }
        }
    }

    /**
     * The derivative at a state, at the source's time.
     *
     * @param s a state; n long
     * @return ds/dt = f(s, t); n long
     */
    protected final double[] derivative(double[] s) {
        double[] dSdt = arrays.next();
        transaction.getStateDerivative(s, dSdt);
        return dSdt;
    }

    /**
     * A multiple of an array.
     *
     * @param factor a number
     * @param a      an array; n long
     * @return factor a; n long
     */
    protected final double[] times(double factor, double[] a) {
        double[] result = arrays.next();
        for (int i = 0; i < result.length; i++) {
            result[i] = factor * a[i];
        }
        return result;
    }

    /**
     * A state beside another one.
     *
     * @param s      a state; n long
     * @param k      a change of it; n long
     * @param factor how much of the change
     * @return s + factor k; n long
     */
    protected final double[] plus(double[] s, double[] k, double factor) {
        double[] result = arrays.next();
        for (int i = 0; i < result.length; i++) {
            result[i] = s[i] + factor * k[i];
        }
        return result;
    }

    /**
     * Whether this step begins exactly where this solver's last one ended: with the same source, state, time and deltaT,
     * bit for bit. Only then may a method use what it remembers of the last step.
     *
     * @return true if it does; false in the first step, after {@link #reset} and after a step that failed
     */
    protected final boolean continuesLastStep() {
        remembering = true;
        return lastStep.continuesFrom(transaction);
    }

    /** @return the step that is being made, for helpers that give it up or look at what else the source offers */
    protected final StepTransaction getTransaction() {
        return transaction;
    }

    /** {@inheritDoc} The next step then continues no other. */
    @Override
    public final void reset() {
        lastStep.forget();
    }
}
