package deSolvers;

/**
 * Thrown when a solver cannot make a step. The message names the solver, the time, the step, the entry of the state
 * where there is one, and the likely cause; the source is as it was before the step.
 */
public class DESolverException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    private final double time;
    private final double deltaT;
    private final int entry;
    private final String reason;

    /**
     * @param solver the class of the solver that gives up
     * @param time   the time at which the step began (s)
     * @param deltaT the requested step (s)
     * @param entry  the index of the state's entry that shows the trouble, or -1 where no single one does
     * @param reason the event, as text to follow a colon
     * @param guess  its likely cause and what to try, as text to follow a semicolon; may be empty
     */
    public DESolverException(Class<? extends DESolver> solver, double time, double deltaT, int entry, String reason,
            String guess) {
        super(solver.getSimpleName() + " at t = " + time + ", deltaT = " + deltaT + ": " + reason
                + (guess.isEmpty() ? "" : "; " + guess));
        this.time = time;
        this.deltaT = deltaT;
        this.entry = entry;
        this.reason = reason;
    }

    /** @return the time at which the step began (s) */
    public double getTime() {
        return time;
    }

    /** @return the requested step (s) */
    public double getDeltaT() {
        return deltaT;
    }

    /** @return the index of the state's entry that shows the trouble, or -1 where no single one does */
    public int getEntry() {
        return entry;
    }

    /** @return the event, without solver, time and guess at its cause */
    public String getReason() {
        return reason;
    }
}
