package deSolvers;

import java.util.Arrays;

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
 * Each call returns an array of its own, valid until the end of the step.
 */
public abstract class FixedStepSolver extends DESolver {
    private final StepTransaction transaction = new StepTransaction(getClass());
    /** How many derivatives of a step are checked by themselves: those that need not show in the new state. */
    private final int checked = this instanceof SumOfDerivatives.AfterTheFirst ? 1
            : this instanceof SumOfDerivatives ? 0 : Integer.MAX_VALUE;
    private int evaluations;                            // in this step
    private double[] state = {};                        // holds s; a source may keep it and give another array
    private double[][] arrays = {};                     // results of the helpers, made once and used again in each step
    private int lent;                                   // the number of these arrays that this step has used
    private int n = -1;

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
            double[] s = startState(source);
            if (deltaT != 0) {
                step(guarded, s, deltaT);
            }
            double[] free = guarded.finishWith(s);
            if (free != s) {                            // the source has kept s
                state = free;
            }
        }
    }

    /** Begins a step: all arrays may be used again; reads the state. */
    private double[] startState(DEStateSource source) {
        if (n != source.getStateSize()) {
            resize(source.getStateSize());
        }
        evaluations = 0;
        lent = 0;
        source.getState(state);
        return state;
    }

    /** Makes arrays for states of another length. */
    private void resize(int size) {
        state = new double[size];
        arrays = new double[0][];
        n = size;
    }

    /** An array that no other call returns until the next step begins; its entries are arbitrary. */
    private double[] next() {
        if (lent == arrays.length) {
            arrays = Arrays.copyOf(arrays, lent + 1);
            arrays[lent] = new double[n];
        }
        return arrays[lent++];
    }

    /**
     * Evaluates the derivative at a state and the source's present time.
     *
     * @param s a state; length n
     * @return f(s, t); length n
     * @throws DESolverException if an entry is not finite; if it shows in the new state, only when the step ends
     */
    protected final double[] derivative(double[] s) {
        double[] dSdt = next();
        transaction.getStateDerivative(s, dSdt);
        if (evaluations++ < checked) {
            transaction.requireFinite(dSdt);
        }
        return dSdt;
    }

    /**
     * Computes the increment of an Euler step, deltaT times the derivative at a state and the source's present time.
     *
     * @param s      a state; length n
     * @param deltaT a time step (s)
     * @return deltaT f(s, t); length n
     * @throws DESolverException as {@link #derivative}
     */
    protected final double[] eulerStep(double[] s, double deltaT) {
        double[] k = next();
        transaction.getIncrement(s, deltaT, k);
        int entry = evaluations++ < checked ? StepTransaction.firstNonFinite(k) : -1;
        if (entry >= 0) {
            double[] dSdt = next();
            transaction.getStateDerivative(s, dSdt);
            transaction.requireFinite(dSdt);
            throw transaction.failure(entry, "entry " + entry + " of the derivative times deltaT is " + k[entry],
                    "deltaT is probably too large");
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
        double[] sum = next();
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
        double[] copy = next();
        System.arraycopy(a, 0, copy, 0, copy.length);
        return copy;
    }

    /** @return the step that is being made, for solvers that need a Jacobian or another interface of the source */
    protected final StepTransaction getTransaction() {
        return transaction;
    }
}
