package deSolvers;

/**
 * A step that either succeeds as a whole or changes nothing: the parts of the contract of {@link DESolver} that are the
 * same for every method, as two calls around the method itself.
 * <pre>
 *     try (StepTransaction source = transaction.begin(client, deltaT)) {
 *         ...                                    // the method moves the source as it likes
 *         source.finish(newState);               // checked, set, clock at exactly t + deltaT
 *     }
 * </pre>
 * Between the two calls this object stands for the client and passes every call on. If the method ends without
 * {@link #finish}, the client gets back the state and the time that {@link #begin} found.
 *
 * <p>The new state is checked for NaN and infinity; if it has one, the message names the first cause.
 */
public final class StepTransaction implements DEStateSource, AutoCloseable {
    private final Class<? extends DESolver> solver;
    private DEStateSource client;
    private boolean hasArrays;                          // whether the client is an ArrayStateSource
    // whether the client still holds the start state in its own array
    private boolean direct;
    private double[] copy = {};                         // of the start state, unless direct
    private double startTime;
    private double deltaT;
    private boolean open;

    /** @param solver the class whose steps these are, for its name in messages */
    public StepTransaction(Class<? extends DESolver> solver) {
        this.solver = solver;
    }

    /**
     * Begins a step: notes the client's state and time.
     *
     * @param client the source to be stepped
     * @param deltaT the time step (s)
     * @return this, which stands for the client until the step ends
     * @throws DESolverException if deltaT, the client's time or the time at the end of the step is not finite
     */
    public StepTransaction begin(DEStateSource client, double deltaT) {
        double time = client.getTime();
        if (!Double.isFinite(time + deltaT)) {
            throw new DESolverException(solver, time, deltaT, -1, invalidEnd(time, deltaT), "");
        }
        if (this.client != client) {
            this.client = client;
            hasArrays = client instanceof ArrayStateSource;     // kept, since a failing instanceof is slow
        }
        direct = hasArrays;
        if (!direct) {
            copyState();
        }
        this.startTime = time;
        this.deltaT = deltaT;
        open = true;
        return this;
    }

    private static String invalidEnd(double time, double deltaT) {
        return !Double.isFinite(deltaT) ? "the time step has to be a finite number"
                : !Double.isFinite(time) ? "the clock of the source has to be a finite number"
                : "the clock of the source cannot go that far";
    }

    private void copyState() {
        if (copy.length != client.getStateSize()) {
            copy = new double[client.getStateSize()];
        }
        client.getState(copy);
    }

    /** @return the state in which the step began; n long, to be read only, valid until the step ends */
    public double[] getStartState() {
        return direct ? ((ArrayStateSource) client).getStateArray() : copy;
    }

    /**
     * Evaluates the derivative at a given state and the client's current time. A client that is no
     * {@link ArrayStateSource} is set to that state.
     *
     * @param state a state; n long
     * @param dSdt  receives ds/dt; n long
     */
    public void getStateDerivative(double[] state, double[] dSdt) {
        if (direct) {
            ((ArrayStateSource) client).getStateDerivative(state, dSdt);
        } else {
            client.setState(state);
            client.getStateDerivative(dSdt);
        }
    }

    /** As {@link #getStateDerivative}, times deltaT. */
    void getIncrement(double[] state, double deltaT, double[] deltaS) {
        if (direct) {
            ((ArrayStateSource) client).getIncrement(state, deltaT, deltaS);
            return;
        }
        client.setState(state);
        client.getStateDerivative(deltaS);
        for (int i = 0; i < deltaS.length; i++) {
            deltaS[i] *= deltaT;
        }
    }

    /**
     * Ends the step: checks that the new state is finite, gives it to the client and moves the clock to t + deltaT.
     * With deltaT = 0 the client is left exactly as it was found.
     *
     * @param newState s(t + deltaT); n long
     * @throws DESolverException if an entry is not finite; the client is then as it was found
     */
    public void finish(double[] newState) {
        if (moveClockToEnd(newState)) {
            client.setState(newState);
            open = false;
        }
    }

    /** As {@link #finish}, for an array that nobody needs any more; returns another one in its place. */
    double[] finishWith(double[] newState) {
        double[] free = newState;
        if (moveClockToEnd(newState)) {
            if (direct) {
                free = ((ArrayStateSource) client).exchangeState(newState);
            } else {
                client.setState(newState);
            }
            open = false;
        }
        return free;
    }

    /** Checks the new state and moves the clock to the end; returns false, and moves nothing, if deltaT is 0. */
    private boolean moveClockToEnd(double[] newState) {
        if (deltaT == 0) {
            requireFiniteStart();
            return false;
        }
        int entry = firstNonFinite(newState);
        if (entry >= 0) {
            throw notFinite(entry, newState[entry]);
        }
        moveTo(startTime + deltaT);                     // first: close() can move it back, but not a state set
        return true;
    }

    /** Moves the clock to a time. The first move may be off by round-off, and a second one is then exact. */
    private void moveTo(double time) {
        double now = client.getTime();
        if (now != time) {
            client.incTime(time - now);
            if (client.getTime() != time) {
                client.incTime(time - client.getTime());
            }
        }
    }

    /** Puts back what {@link #begin} found, unless {@link #finish} ended the step. */
    @Override
    public void close() {
        if (open) {
            open = false;
            try {
                if (!direct) {
                    client.setState(copy);
                }
            } finally {
                moveTo(startTime);
            }
        }
    }

    /** @return the source itself, for its interfaces beyond the simple one; to be moved only through this step */
    public DEStateSource getClient() {
        return client;
    }

    /** @return the time at which the step began (s) */
    public double getStartTime() {
        return startTime;
    }

    double getDeltaT() {
        return deltaT;
    }

    /**
     * Puts the client's clock to a time within the step, as near as one move gets.
     *
     * @param offset the time since the step began (s); negative where deltaT is
     */
    public void setOffset(double offset) {
        double now = client.getTime();
        client.incTime(now == startTime ? offset : startTime + offset - now);
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
            throw failure(entry, "entry " + entry + " of the derivative is " + dSdt[entry] + " at t = "
                    + client.getTime(), "the source divides by zero or overflows there");
        }
    }

    /**
     * @param values any numbers
     * @return the index of the first one that is NaN or infinite, or -1
     */
    public static int firstNonFinite(double[] values) {
        int i = 0;
        // A sum is finite only if all its terms are. So eight are checked at once, in half the time.
        while (i <= values.length - 8 && Double.isFinite(values[i] + values[i + 1] + (values[i + 2] + values[i + 3])
                + (values[i + 4] + values[i + 5] + (values[i + 6] + values[i + 7])))) {
            i += 8;
        }
        for (; i < values.length; i++) {
            if (!Double.isFinite(values[i])) {
                return i;
            }
        }
        return -1;
    }

    /**
     * Checks the state in which the step began.
     *
     * @throws DESolverException if an entry is not finite
     */
    public void requireFiniteStart() {
        double[] found = getStartState();
        int entry = firstNonFinite(found);
        if (entry >= 0) {
            throw failure(entry, "entry " + entry + " of the state is " + found[entry]
                    + " before the step", "the fault is in the code that set the state");
        }
    }

    /**
     * Makes the exception for a step that the method gives up, with the step's solver, time and deltaT.
     *
     * @param entry  the index of the state's entry that shows the trouble, or -1
     * @param reason the event
     * @param guess  its likely cause and what to try; may be empty
     * @return the exception, to be thrown
     */
    public DESolverException failure(int entry, String reason, String guess) {
        return new DESolverException(solver, startTime, deltaT, entry, reason, guess);
    }

    /** The first cause: a bad start state, a bad derivative there, or else a step that is too long. */
    private DESolverException notFinite(int entry, double value) {
        requireFiniteStart();
        close();
        double[] dSdt = new double[getStateSize()];
        client.getStateDerivative(dSdt);
        requireFinite(dSdt);
        return failure(entry, "entry " + entry + " of the state became " + value
                + " within the step, from a finite state and derivative", "deltaT is probably too large, or the"
                + " derivative is not finite further on");
    }

    @Override
    public int getStateSize() {
        return getStartState().length;
    }

    @Override
    public void getState(double[] state) {
        client.getState(state);
    }

    @Override
    public void setState(double[] state) {
        if (direct) {
            copyState();                                // the client's own array is about to change
            direct = false;
        }
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
}
