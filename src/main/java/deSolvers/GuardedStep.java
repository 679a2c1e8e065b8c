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
 * <p>Whether a state is finite is looked at once, at the end: each stage enters the new state, or the place where a later
 * one is evaluated, with a weight that is not 0, and no finite factor makes an infinity or a NaN finite again. Only when the
 * check fails is the cause looked for.
 */
public final class GuardedStep implements DEStateSource, AutoCloseable {
    /** Below this many doubles copying the new state in is cheaper than exchanging arrays. */
    private static final int EXCHANGE_FROM = 64;

    private final DESolver solver;
    private DEStateSource client;
    private boolean direct;                             // whether the client's own arrays are used in this step
    private double[] copy = {};                         // of the state that was found, unless the client's own array is used
    private double timeFound;
    private double deltaT;
    private boolean open;
    private boolean moved;

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
     * @throws DESolverException if deltaT, the client's time or the time at the end of the step is not finite
     */
    public GuardedStep begin(DEStateSource client, double deltaT) {
        double time = client.getTime();
        if (!Double.isFinite(time + deltaT)) {          // where one of them is not, the sum is not
            throw new DESolverException(solver, time, deltaT, -1, NotFinite.end(time, deltaT));
        }
        if (this.client != client) {                    // each reference that is stored costs the garbage collector's note
            this.client = client;
        }
        direct = client instanceof ArrayStateSource;
        if (!direct) {
            copyState();
        }
        this.timeFound = time;
        this.deltaT = deltaT;
        moved = false;
        open = true;
        return this;
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
     * Evaluates the derivative at a given state and the client's current time: at the array itself where the client offers
     * that, by setting the client's state where it does not.
     *
     * @param state a state; n long
     * @param dSdt  receives ds/dt; n long
     */
    public void getStateDerivative(double[] state, double[] dSdt) {
        if (direct) {
            ((ArrayStateSource) client).getStateDerivative(state, dSdt);
        } else {
            moveAndEvaluate(state, dSdt);
        }
    }

    private void moveAndEvaluate(double[] state, double[] dSdt) {
        if (moved || state != copy) {
            client.setState(state);
            moved = true;
        }
        client.getStateDerivative(dSdt);
    }

    /**
     * Ends the step like {@link #finish(double[])}, and hands the array itself over where the client takes it.
     *
     * @param newState s(t + deltaT); n long, not to be used any more
     * @return an array of the same length for the solver to use in its place
     * @throws DESolverException if an entry is not finite; the client is then as it was found
     */
    public double[] handOver(double[] newState) {
        if (!direct || newState.length < EXCHANGE_FROM || deltaT == 0) {
            finish(newState);
            return newState;
        }
        requireFiniteEnd(newState);
        SourceClock.moveToEnd(client, timeFound, deltaT);
        double[] free = ((ArrayStateSource) client).exchangeState(newState);
        open = false;
        return free;
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
            requireFiniteStart();
            return;                                     // close() puts back what was found
        }
        requireFiniteEnd(newState);
        end(newState);
    }

    /**
     * Ends the step like {@link #finish(double[])}, and checks a derivative as {@link #requireFinite} does.
     *
     * @param newState s(t + deltaT); n long
     * @param dSdt     the derivative that was evaluated last; n long
     * @throws DESolverException if an entry of either is not finite; the client is then as it was found
     */
    public void finish(double[] newState, double[] dSdt) {
        if (deltaT == 0 || !FiniteCheck.areFinite(newState, dSdt)) {
            requireFinite(dSdt);
            finish(newState);
        } else {
            end(newState);
        }
    }

    private void end(double[] newState) {
        SourceClock.moveToEnd(client, timeFound, deltaT);       // first: it can be moved back, a state handed over cannot
        client.setState(newState);
        open = false;
    }

    private void requireFiniteEnd(double[] newState) {
        int entry = FiniteCheck.firstNonFinite(newState);
        if (entry >= 0) {
            throw notFinite(entry, newState[entry]);
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
                SourceClock.moveTo(client, timeFound);
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
        SourceClock.moveWithin(client, timeFound, offset);
    }

    /**
     * Checks a derivative by itself, for methods that do not put every entry of it into the new state.
     *
     * @param dSdt the derivative at the present state and time
     * @throws DESolverException if an entry is not finite
     */
    public void requireFinite(double[] dSdt) {
        int entry = FiniteCheck.firstNonFinite(dSdt);
        if (entry >= 0) {
            throw derivativeNotFinite(entry, dSdt[entry]);
        }
    }

    private DESolverException derivativeNotFinite(int entry, double value) {
        requireFiniteStart();
        return failure(entry, NotFinite.derivative(entry, value, client.getTime()));
    }

    /**
     * Checks the state in which the step began.
     *
     * @throws DESolverException if an entry is not finite
     */
    public void requireFiniteStart() {
        double[] found = getStartState();
        int entry = FiniteCheck.firstNonFinite(found);
        if (entry >= 0) {
            throw failure(entry, NotFinite.found(entry, found[entry]));
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

    /** Looks for the cause where the step began: in the state, in the derivative, or else in the size of the step. */
    private DESolverException notFinite(int entry, double value) {
        requireFiniteStart();
        close();
        double[] dSdt = new double[getStateSize()];
        client.getStateDerivative(dSdt);
        requireFinite(dSdt);
        return failure(entry, NotFinite.made(entry, value));
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
        moved = true;
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
                + Arrays.toString(getStartState());
    }
}
