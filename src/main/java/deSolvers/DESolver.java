package deSolvers;

/**
 * A numerical solver: advances a system of ordinary differential equations ds/dt = f(s, t) by a time step. All solvers
 * extend this class; to write one, implement {@link #stepState}.
 *
 * <p><b>A solver must</b> read state and derivative, compute, and leave the source at state s(t + deltaT) and time
 * t + deltaT, and come back, also where the derivative is NaN. A student's solver need do no more.
 *
 * <p><b>The solvers in this project follow these rules too</b>, and tests check them. A solver that extends
 * {@link FixedStepSolver} follows them without code of its own:
 * <ul>
 * <li>The source has one current state and time, and a solver may change both while it works:
 *     {@code setState(trial)}, {@code incTime(deltaT / 2)}, also backwards. At the end the clock is at t + deltaT, up
 *     to round-off.</li>
 * <li>On an exception, its own or the source's, the solver puts back the state and the time that it found and lets the
 *     exception reach the caller. The solver may be used again.</li>
 * <li>Arrays handed to the source are exactly {@link DEStateSource#getStateSize()} long.</li>
 * <li>One solver may step any number of sources, of equal or different sizes, in turn. A solver that remembers its last
 *     step uses it only if source, time (but for round-off) and state are as at its end, and deltaT is the same.
 *     If the equations change while the state stays the same, the caller has to call {@link #reset()}.</li>
 * <li>A step allocates no memory once the work arrays have the source's size.</li>
 * <li>{@code deltaT = 0} changes nothing; a negative deltaT integrates backwards; a state of size 0 still moves the
 *     clock. A deltaT, time, state or derivative that is not finite ends in a {@link DESolverException}.</li>
 * </ul>
 *
 * <p>Source: COMPSCI 715 (2003), slide "Interface to DE Solver"; {@link #reset()} is an addition to the slide.
 */
public abstract class DESolver {

    /**
     * Advances the source by deltaT, from (s, t) to (s(t + deltaT), t + deltaT).
     *
     * @param source the system to advance; holds state and time before and after
     * @param deltaT the time step, in the source's unit of time (s); may be negative or 0, must be finite
     * @throws DESolverException if the step cannot be made; the source is then as it was
     */
    public abstract void stepState(DEStateSource source, double deltaT);

    /**
     * Discards all memory of earlier steps. The simulation calls it when a rule has changed something, since then
     * the equations may differ while the state is the same. A solver without memory does nothing here.
     */
    public void reset() {
    }
}
