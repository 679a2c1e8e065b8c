package deSolvers;

/**
 * A source whose state is one array of doubles and whose derivative can be evaluated at any such array. Solvers that
 * know this type evaluate at their own arrays, without a setState for each trial state. The results have the same bits
 * as through the plain {@link DEStateSource}. It pays for large systems, where copying costs as much as the arithmetic
 * of a stage.
 */
public interface ArrayStateSource extends DEStateSource {

    /**
     * The array that holds the current state.
     *
     * @return s itself, exactly {@link #getStateSize()} long; to be read only, valid until the state is set
     */
    double[] getStateArray();

    /**
     * Evaluates the derivative at a given state and the current time; changes neither.
     *
     * @param state a state; n long
     * @param dSdt  receives ds/dt; n long, another array than {@code state}
     */
    void getStateDerivative(double[] state, double[] dSdt);

    /**
     * Computes deltaT times the derivative; a source overrides it where that saves a pass over the array.
     *
     * @param state  a state; n long
     * @param deltaT the time step (s)
     * @param deltaS receives deltaT ds/dt at that state and the current time; n long, another array
     */
    default void getIncrement(double[] state, double deltaT, double[] deltaS) {
        getStateDerivative(state, deltaS);
        for (int i = 0; i < deltaS.length; i++) {
            deltaS[i] *= deltaT;
        }
    }

    /**
     * Sets the state as {@link #setState}, but takes the array itself where that saves a copy.
     *
     * @param state the new state; n long; the caller must not use it any more
     * @return an array of n arbitrary entries, the caller's from now on: the source's former one, or {@code state}
     */
    default double[] exchangeState(double[] state) {
        setState(state);
        return state;
    }
}
