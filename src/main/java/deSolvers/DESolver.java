package deSolvers;

/**
 * A method that advances a system of ordinary differential equations ds/dt = f(s, t) in time: the abstract class of
 * the course from which all solvers are subclassed. Writing a solver means writing {@link #stepState}.
 *
 * <p><b>What a solver must do</b>: read state and derivative, compute, and leave the source at state s(t + deltaT) and
 * time t + deltaT. A student's solver need do no more.
 *
 * <p><b>What the solvers of this project keep besides</b>, and are tested for; {@link FixedStepSolver} keeps it for a
 * solver that writes only its formula:
 * <ul>
 * <li>The source is a cursor (s, t). A solver may move it while it works - {@code setState(trial)},
 *     {@code incTime(deltaT / 2)}, backwards too. At the end the clock is at t + deltaT, to the last digit if deltaT is
 *     0.25, 0.5 or the like, and else up to round-off.</li>
 * <li>On an exception, its own or the source's, it puts back the state and the time that it found and lets the
 *     exception reach the caller. The solver may be used again.</li>
 * <li>Arrays handed to the source are exactly {@link DEStateSource#getStateSize()} long.</li>
 * <li>One solver may step any number of sources, of equal or different sizes, in turn. A solver that remembers its last
 *     step uses it only if source, time, state and deltaT are bit for bit as they were left. If the equations change
 *     while the state stays the same, {@link #reset()} makes it forget.</li>
 * <li>A step allocates no memory once the work arrays have the source's size.</li>
 * <li>{@code deltaT = 0} changes nothing; a negative deltaT integrates backwards; a state of size 0 still moves the
 *     clock. A deltaT, time, state or derivative that is not finite ends in a {@link DESolverException}.</li>
 * </ul>
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
     * Forgets what was remembered of earlier steps. To be called when the equations changed although the state did not.
     * Solvers that remember nothing do nothing here.
     */
    public void reset() {
    }
}
