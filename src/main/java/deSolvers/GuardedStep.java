package deSolvers;

import java.util.Arrays;

/**
 * The parts of the contract of {@link DESolver} that are the same for every method, as two calls around a step's body:
 * <pre>
 *     try (GuardedStep source = guard.begin(client, deltaT)) {
 *         source.getState(state);                // the body moves the source as it likes
 *         ...
 *         source.finish(newState);               // checked, handed over, clock at exactly t + deltaT
 *     }
 * </pre>
 * Between the two calls this object stands for the client: it passes every call on. If the body ends without
 * {@link #finish}, by whatever exception, the client gets back the state and the time that {@link #begin} found.
 *
 * <p>Whether a state is finite is looked at once, at the end: each stage enters the new state with a weight that is not 0,
 * and no finite factor makes an infinity or a NaN finite again. Only when the check fails is the cause looked for.
 */
public final class GuardedStep implements DEStateSource, AutoCloseable {
    private final DESolver solver;
    private DEStateSource client;
    private double[] stateFound = {};
    private double timeFound;
    private double deltaT;
    private boolean open;

    /** @param solver the solver whose steps are guarded, for its name in messages */
    public GuardedStep(DESolver solver) {
        this.solver = solver;
    }

    /**
     * Begins a step: notes the client's state and time.
     *
     * @param client the source to be stepped
     * @param deltaT the time step (s)
     * @return this, which stands for the client until the step ends
     * @throws DESolverException if deltaT or the client's time is not finite
     */
    public GuardedStep begin(DEStateSource client, double deltaT) {
        if (!Double.isFinite(deltaT)) {
            throw new DESolverException(solver, client.getTime(), deltaT, -1, "the time step has to be a finite number");
        }
        double time = client.getTime();
        if (!Double.isFinite(time)) {
            throw new DESolverException(solver, time, deltaT, -1, "the clock of the source has to be a finite number");
        }
        int n = client.getStateSize();
        if (stateFound.length != n) {
            stateFound = new double[n];
        }
        client.getState(stateFound);
        this.client = client;
        this.timeFound = time;
        this.deltaT = deltaT;
        this.open = true;
        return this;
    }

    /**
     * Ends the step: checks that the new state is finite, hands it to the client and moves the clock to t + deltaT.
     * With deltaT = 0 the client is left exactly as it was found.
     *
     * @param newState s(t + deltaT); n long
     * @throws DESolverException if an entry is not finite; the client is then as it was found
     */
    public void finish(double[] newState) {
        if (deltaT == 0) {
            return;                                     // close() puts back what was found
        }
        int entry = firstNonFinite(newState);
        if (entry >= 0) {
            throw notFinite(entry, newState[entry]);
        }
        client.setState(newState);
        moveClockTo(timeFound + deltaT);
        open = false;
    }

    /** Puts back what {@link #begin} found, unless {@link #finish} ended the step. */
    @Override
    public void close() {
        if (open) {
            open = false;
            try {
                client.setState(stateFound);
            } finally {
                moveClockTo(timeFound);
            }
        }
    }

    /** @return the source itself, for what it offers beyond the simple interface; to be moved only through this step */
    public DEStateSource getClient() {
        return client;
    }

    /** @return the time at which the step began (s) */
    public double getStartTime() {
        return timeFound;
    }

    /** @return the time at which {@link #finish} leaves the clock (s) */
    public double getEndTime() {
        return timeFound + deltaT;
    }

    /**
     * Puts the client's clock to a time within the step.
     *
     * @param offset the time since the step began (s); negative where deltaT is
     */
    public void setOffset(double offset) {
        client.incTime(timeFound + offset - client.getTime());
    }

    /**
     * Checks a derivative by itself, for methods that do not put every entry of it into the new state.
     *
     * @param dSdt the derivative at the present state and time
     * @throws DESolverException if an entry is not finite
     */
    public void requireFinite(double[] dSdt) {
        int entry = firstNonFinite(dSdt);
        if (entry >= 0) {
            requireFiniteStart();
            throw failure(entry, "entry " + entry + " of the derivative is " + dSdt[entry] + " at t = " + client.getTime()
                    + "; the source divides by zero or overflows there");
        }
    }

    /**
     * Checks the state in which the step began.
     *
     * @throws DESolverException if an entry is not finite
     */
    public void requireFiniteStart() {
        int entry = firstNonFinite(stateFound);
        if (entry >= 0) {
            throw failure(entry, "entry " + entry + " of the state is " + stateFound[entry]
                    + " before the step; whatever set the state has to be mended");
        }
    }

    /**
     * An exception for a step that the body gives up, with the step's solver, time and deltaT.
     *
     * @param entry the index of the state's entry that shows the trouble, or -1
     * @param cause what happened and why that is likely
     * @return the exception, to be thrown
     */
    public DESolverException failure(int entry, String cause) {
        return new DESolverException(solver, timeFound, deltaT, entry, cause);
    }

    /** A difference of two clock readings may round; what is left after one move is so small that a second is exact. */
    private void moveClockTo(double time) {
        client.incTime(time - client.getTime());
        if (client.getTime() != time) {
            client.incTime(time - client.getTime());
        }
    }

    /**
     * @param values any numbers
     * @return the index of the first one that is NaN or infinite, or -1
     */
    public static int firstNonFinite(double[] values) {
        for (int i = 0; i < values.length; i++) {
            if (!Double.isFinite(values[i])) {
                return i;
            }
        }
        return -1;
    }

    /** Looks for the cause where the step began: in the state, in the derivative, or else in the size of the step. */
    private DESolverException notFinite(int entry, double value) {
        requireFiniteStart();
        close();
        double[] dSdt = new double[stateFound.length];
        client.getStateDerivative(dSdt);
        requireFinite(dSdt);
        return failure(entry, "entry " + entry + " of the state became " + value + " within the step, from a finite state"
                + " and derivative; deltaT is probably too large, or the derivative is not finite further on");
    }

    @Override
    public int getStateSize() {
        return stateFound.length;
    }

    @Override
    public void getState(double[] state) {
        client.getState(state);
    }

    @Override
    public void setState(double[] state) {
        client.setState(state);
    }

    @Override
    public void getStateDerivative(double[] dSdt) {
        client.getStateDerivative(dSdt);
    }

    @Override
    public double getTime() {
        return client.getTime();
    }

    @Override
    public void incTime(double deltaT) {
        client.incTime(deltaT);
    }

    @Override
    public String toString() {
        return "a step of " + solver.getClass().getSimpleName() + " from t = " + timeFound + " with "
                + Arrays.toString(stateFound);
    }
}
