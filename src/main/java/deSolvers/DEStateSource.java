package deSolvers;

/**
 * A system of ordinary differential equations as a {@link DESolver} sees it: its state s in R<sup>n</sup>, its clock t
 * and its derivative ds/dt = f(s, t). A particle system is one.
 *
 * <p>A source has one current state and time. A solver sets them to trial values, asks for the derivative there, and
 * goes on. Arrays belong to the caller and are exactly {@link #getStateSize()} long; these methods copy them and keep
 * no reference.
 *
 * <p>Source: COMPSCI 715 (2003), slide "DEStateSource". That slide is lost; the slide "Euler Solver Code" shows four
 * of the methods in use. {@link #getStateSize()} and {@link #getTime()} are this project's choice.
 */
public interface DEStateSource {

    /**
     * Returns the number of doubles in the state.
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
     * Returns the time on the source's clock.
     *
     * @return t (s)
     */
    double getTime();

    /**
     * Moves the clock. The state does not change.
     *
     * @param deltaT the time to add (s); may be negative
     */
    void incTime(double deltaT);
}
