package deSolvers;

/**
 * A source whose state is one array of doubles and whose derivative can be evaluated at any such array. Solvers that
 * know this type copy nothing: they evaluate at their own arrays and hand the new state over instead of copying it in.
 * The results have the same bits as through the plain {@link DEStateSource}. Worth offering for large systems, where
 * copies cost as much as a stage's arithmetic.
 */
public interface ArrayStateSource extends DEStateSource {

    /**
     * The array that holds the current state.
     *
     * @return s itself, exactly {@link #getStateSize()} long; to be read only, valid until the state is set or handed
     *         over
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
     * Takes an array as the new state. It is the source's from now on, and the one that held the state before is the
     * caller's.
     *
     * @param state the new s; n long
     * @return the array that held the state until now
     */
    double[] exchangeState(double[] state);
}
