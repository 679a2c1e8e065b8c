package deSolvers;

/**
 * A method that advances a system of ordinary differential equations ds/dt = f(s, t) in time: the abstract class of
 * the course from which all solvers are subclassed. Writing a solver means writing {@link #stepState}.
 *
 * <p><b>The contract</b> that every solver of this project keeps (and that the project's tests hold them to):
 * <ul>
 * <li>The source is a cursor (s, t). A solver may move it while it works - {@code setState(trial)},
 *     {@code incTime(deltaT / 2)}, backwards too - and leaves it at (s(t + deltaT), t + deltaT), the clock exactly
 *     there for a dyadic deltaT and within one unit in the last place otherwise.</li>
 * <li>On an exception, its own or the source's, it puts back the state and the time that it found and lets the
 *     exception reach the caller. The next call works as if nothing had happened, or as a new solver's first.</li>
 * <li>Arrays handed to the source are exactly {@link DEStateSource#getStateSize()} long.</li>
 * <li>One solver may step any number of sources, of equal or different sizes, in turn. What it remembers of the last
 *     step serves only while source, time, state and deltaT are bit for bit what it left; anything else restarts
 *     it. A law that changes without the state changing has to be told by {@link #reset()}.</li>
 * <li>A step allocates no memory once the work arrays have the source's size.</li>
 * <li>{@code deltaT = 0} changes nothing; a negative deltaT integrates backwards; a state of size 0 still moves the
 *     clock. A deltaT, time, state or derivative that is not finite ends in a {@link DESolverException}.</li>
 * </ul>
 * {@link FixedStepSolver} keeps this contract around a method that is written as its formula.
 *
 * <p>Source: COMPSCI 715 (2003), slide "Interface to DE Solver"; {@link #reset()} is an addition to the slide.
 */
public abstract class DESolver {

    /**
     * Advances the source by exactly deltaT, from (s, t) to (s(t + deltaT), t + deltaT).
     *
     * @param source the system to advance; holds state and time before and after
     * @param deltaT the time step, in the source's unit of time (s); may be negative or 0, must be finite
     * @throws DESolverException if the step cannot be made; the source is then as it was
     */
    public abstract void stepState(DEStateSource source, double deltaT);

    /**
     * Forgets what was remembered of earlier steps. To be called when the source's law changed although its state did
     * not, and wherever a run must not depend on what came before. Solvers that remember nothing do nothing here.
     */
    public void reset() {
    }
}
