package deSolvers;

/**
 * What a client - a particle system, or any other system of ordinary differential equations - provides to a
 * {@link DESolver}: its state s in R<sup>n</sup>, its clock t, and its derivative ds/dt = f(s, t).
 *
 * <p>A source is a cursor: a solver moves it to trial states and times, asks for the derivative there, and moves it on.
 * Arrays belong to the caller, are exactly {@link #getStateSize()} long, and are copied: no source keeps a reference.
 *
 * <p>Source: COMPSCI 715 (2003), slide "DEStateSource". The slide's body is lost but for the calls that the slide's
 * Euler solver makes; {@link #getStateSize()} and {@link #getTime()} are therefore this project's choice.
 */
public interface DEStateSource {

    /**
     * The number of doubles in the state.
     *
     * @return n, 0 or more; constant during a step
     */
    int getStateSize();

    /**
     * Copies the state out.
     *
     * @param state receives s; n long
     */
    void getState(double[] state);

    /**
     * Copies a state in. The clock stays where it is.
     *
     * @param state the new s; n long
     */
    void setState(double[] state);

    /**
     * Evaluates the derivative at the current state and time; changes neither.
     *
     * @param dSdt receives ds/dt = f(s, t), per unit of time; n long
     */
    void getStateDerivative(double[] dSdt);

    /**
     * The source's clock.
     *
     * @return t (s)
     */
    double getTime();

    /**
     * Moves the clock. The state stays what it is.
     *
     * @param deltaT what to add to the time (s); may be negative
     */
    void incTime(double deltaT);
}
