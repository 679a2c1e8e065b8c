package deSolvers.adaptive;

import deSolvers.DESolver;
import deSolvers.DESolverException;
import deSolvers.DEStateSource;
import deSolvers.LastStep;
import deSolvers.StepTransaction;
import deSolvers.SubStepSource;
import deSolvers.TimeScaleSource;

/**
 * Base class of adaptive solvers: step-size control. It covers deltaT exactly by sub-steps whose estimated error is
 * within the tolerance. It tries a sub-step, accepts it or tries a shorter one, and chooses the next length. A step
 * that continues the last one begins with the length found there.
 *
 * <p>A method implements one sub-step ({@link #attempt}) and states the power of h to which its error is proportional
 * ({@link #errorExponent}).
 */
public abstract class AdaptiveSolver extends DESolver {
    /** The default error allowed for an entry of the state, relative to its size. */
    public static final double RELATIVE_TOLERANCE = 1e-6;
    /** The default error allowed besides, in the entry's unit. */
    public static final double ABSOLUTE_TOLERANCE = 1e-9;
    /** The largest relative tolerance: with more, motion too fast for the method may grow without bound. */
    public static final double LOOSEST_TOLERANCE = 1e-3;
    /** The largest number of sub-steps, taken or rejected, in a step. */
    public static final int MOST_SUB_STEPS = 500_000;

    /** After this number of sub-steps, their progress is compared with the rest of the step. */
    private static final int WINDOW = 10_000;

    private static final double SAFETY = 0.9;
    private static final double MOST_SHRINKING = 0.2;
    private static final double MOST_GROWTH = 10;

    private final Tolerance tolerance;
    private final StepTransaction transaction = new StepTransaction(getClass());
    private final LastStep lastStep = new LastStep();
    private double[] state = {};
    private double[] newState = {};
    private double[] slope = {};
    private double[] newSlope = {};
    private boolean slopeKnown;
    private double subStep;                             // length of the next sub-step, > 0 (s)
    private boolean rejected;
    private double windowBegin;                         // how much was done before the last sub-steps (s)
    private double lastHeadway;                         // and how much in those before them (s)

    /**
     * @param relativeTolerance error allowed for an entry of the state in one sub-step, relative to its size
     * @param absoluteTolerance error allowed besides, in the entry's unit
     * @throws IllegalArgumentException if one of them is negative or not finite, or both are 0, or the relative one is
     *                                  more than {@value #LOOSEST_TOLERANCE}
     */
    protected AdaptiveSolver(double relativeTolerance, double absoluteTolerance) {
        tolerance = new Tolerance(relativeTolerance, absoluteTolerance);
        if (relativeTolerance > LOOSEST_TOLERANCE) {
            throw new IllegalArgumentException("relativeTolerance " + relativeTolerance + " is more than "
                    + LOOSEST_TOLERANCE + ": a fast vibration could grow by that part in every sub-step");
        }
    }

    /**
     * Makes the work arrays.
     *
     * @param n the state's size from now on
     */
    protected abstract void resize(int n);

    /** Clears a method's memory of earlier sub-steps; called when a step does not continue the last one. */
    protected void restart() {
    }

    /**
     * Tries one sub-step.
     *
     * @param source   the step's source, in any state; may be left in any state
     * @param state    the state at the beginning; not to be changed
     * @param slope    the derivative there; not to be changed
     * @param offset   time from the beginning of the step to that of the sub-step (s)
     * @param h        the sub-step (s); negative if deltaT is
     * @param newState receives the state at the end
     * @return the estimated error in units of the tolerance, from {@link Tolerance#ratio}
     */
    protected abstract double attempt(StepTransaction source, double[] state, double[] slope, double offset, double h,
                                      double[] newState);

    /** @return e if the estimated error is O(h<sup>e</sup>) */
    protected abstract int errorExponent();

    /**
     * Returns the derivative at the end of the sub-step just tried, if the method knows it.
     *
     * @param newSlope receives it
     * @return whether it is known; otherwise newSlope is unchanged
     */
    protected boolean endSlope(double[] newSlope) {
        return false;
    }

    /**
     * Chooses the length of the next sub-step.
     *
     * @param h     the length of the one just tried, &gt; 0 (s)
     * @param error its error in units of the tolerance; at most 1 if it is taken
     * @return the next length, &gt; 0 (s)
     */
    protected double nextSubStep(double h, double error) {
        double factor = SAFETY / root(error, errorExponent());
        return h * Math.max(MOST_SHRINKING, Math.min(MOST_GROWTH, factor));
    }

    /**
     * A root by exponential and logarithm, because StrictMath.pow allocates memory on JDK 17.
     *
     * @param x        0 or more, or infinite
     * @param exponent e, 1 or more
     * @return x<sup>1/e</sup>
     */
    public static double root(double x, double exponent) {
        return StrictMath.exp(StrictMath.log(x) / exponent);
    }

    /** @return the tolerance */
    protected final Tolerance getTolerance() {
        return tolerance;
    }

    @Override
    public final void stepState(DEStateSource client, double deltaT) {
        int n = client.getStateSize();
        if (state.length != n) {
            state = new double[n];
            newState = new double[n];
            slope = new double[n];
            newSlope = new double[n];
            resize(n);
            lastStep.forget();
        }
        try (StepTransaction source = transaction.begin(client, deltaT)) {
            source.requireFiniteStart();
            if (deltaT == 0) {
                return;
            }
            boolean continues = lastStep.continuesFrom(source);
            source.getState(state);
            if (!continues) {
                begin(source, deltaT);
            }
            cover(source, deltaT);
            lastStep.keep(source, state);
            source.finish(state);
        }
    }

    /** Starts a new run: evaluates the derivative and guesses the first sub-step. */
    private void begin(StepTransaction source, double deltaT) {
        restart();
        rejected = false;
        source.getStateDerivative(slope);               // at (s, t)
        source.requireFinite(slope);
        slopeKnown = true;
        subStep = firstSubStep(source, deltaT);
    }

    /**
     * Guesses the length of the first sub-step (s) from the first two derivatives of the solution (Hairer,
     * N&oslash;rsett, Wanner, section II.4); a trial Euler step shows how fast the derivative changes.
     */
    private double firstSubStep(StepTransaction source, double deltaT) {
        double length = Math.abs(deltaT);
        double size = tolerance.size(state, state);
        double speed = tolerance.size(slope, state);
        // A hundredth of the time in which the state would change by its own size; unknown for a state of about 0.
        double slow = size > 1 && speed > 0 ? 0.01 * (size / speed) : Double.POSITIVE_INFINITY;
        double euler = Math.min(length, slow);
        if (slow == Double.POSITIVE_INFINITY && speed > 1 / length) {
            euler = 1 / speed;                          // as far as the tolerance reaches
        }
        if (!(euler >= Double.MIN_NORMAL)) {
            return length;                              // too short for a trial
        }
        double h = Math.copySign(euler, deltaT);
        for (int i = 0; i < state.length; i++) {
            newState[i] = state[i] + h * slope[i];
        }
        source.setState(newState);
        source.setOffset(h);
        source.getStateDerivative(newSlope);            // at (s + h f, t + h)
        for (int i = 0; i < state.length; i++) {
            newSlope[i] = (newSlope[i] - slope[i]) / euler;
        }
        double fastest = Math.max(speed, tolerance.size(newSlope, state));
        double byChange = fastest > 0 ? root(0.01 / fastest, errorExponent()) : length;
        double guess = Math.min(length, Math.min(100 * slow, byChange));
        return guess > 0 ? guess : euler;               // also if the trial gave NaN
    }

    /** Makes sub-steps from 0 to exactly deltaT. Lengths are positive here; the direction is a factor. */
    private void cover(StepTransaction source, double deltaT) {
        double direction = Math.signum(deltaT);
        double length = Math.abs(deltaT);
        double done = 0;
        for (int tried = 0; done < length; tried++) {
            double remaining = length - done;
            double resolution = resolution(source, done);
            subStep = Math.min(subStep, TimeScaleSource.PART * shortestTime(source, state, direction * done));
            subStep = Math.max(subStep, resolution);    // a guess or a plan may be finer than the clock
            requireFewSubSteps(source, tried, done, length);
            double h = subStep >= remaining ? remaining
                    // two halves rather than a long and a tiny one
                    : subStep > remaining / 2 ? remaining / 2 : subStep;
            if (!slopeKnown) {
                source.setState(state);
                source.setOffset(direction * done);
                source.getStateDerivative(slope);       // at the end of the last sub-step
                source.requireFinite(slope);
                slopeKnown = true;
            }
            double error = attempt(source, state, slope, direction * done, direction * h, newState);
            double longest = error <= 1 && h > resolution ? longest(source, direction * done, direction * h) : h;
            if (longest < h) {                          // it passed, or may have passed, what it did not see
                subStep = longest;
                rejected = true;
                continue;
            }
            double next = nextSubStep(h, error);
            if (error <= 1) {
                double end = h == remaining ? length : done + h;
                accept();
                done = end;
                if (source.getClient() instanceof SubStepSource client) {
                    client.subStepTaken(state, source.getStartTime() + direction * done);
                }
                // An accepted sub-step that was shortened to end at deltaT keeps the planned length.
                boolean cut = h < subStep && next >= 2 * h;
                subStep = cut ? Math.max(subStep, next) : rejected ? Math.min(next, h) : next;
                rejected = false;
            } else if (h <= resolution) {
                throw tooShort(source, h, done, resolution);
            } else {
                subStep = Math.min(next, h * SAFETY);
                rejected = true;
            }
        }
    }

    /** The shortest time in which the derivative may change and change back (s). */
    private static double shortestTime(StepTransaction source, double[] state, double offset) {
        return source.getClient() instanceof TimeScaleSource client
                ? client.getShortestTime(state, source.getStartTime() + offset) : Double.POSITIVE_INFINITY;
    }

    /** The longest sub-step (s) that misses no change of the derivative, at most h; h is within the tolerance. */
    private double longest(StepTransaction source, double offset, double h) {
        if (Math.abs(h) > shortestTime(source, newState, offset + h)) {
            return Math.abs(h) / 2;
        }
        double begin = source.getStartTime() + offset;
        return source.getClient() instanceof TimeScaleSource client
                ? Math.min(client.findPassage(state, begin, newState, begin + h), Math.abs(h)) : Math.abs(h);
    }

    /** Makes the new state the current one. */
    private void accept() {
        boolean known = endSlope(newSlope);
        double[] oldState = state;
        state = newState;
        newState = oldState;
        double[] oldSlope = slope;
        slope = newSlope;
        newSlope = oldSlope;
        slopeKnown = known;
    }

    /** The shortest sub-step that changes the clock and the sum (s); only deltaT itself may be shorter. */
    private static double resolution(StepTransaction source, double done) {
        return 4 * Math.max(Math.ulp(source.getStartTime()), Math.ulp(done));
    }

    /** The exception for a rejected sub-step that cannot become shorter. */
    private DESolverException tooShort(StepTransaction source, double h, double done, double resolution) {
        int entry = tolerance.getWorstEntry();
        String failure = entry < 0 ? "cannot be made even so"
                : "leaves entry " + entry + " of the state outside its tolerance";
        return source.failure(entry,
                "the sub-step fell to " + h + " s after " + done + " s, where the resolution of the"
                + " clock is " + resolution + " s, and still " + failure,
                "the solution or its derivative grows without bound or jumps there, or it changes too fast for so"
                + " late a clock, or the tolerance is below rounding");
    }

    private void requireFewSubSteps(StepTransaction source, int tried, double done, double length) {
        if (tried >= MOST_SUB_STEPS || tried % WINDOW == 0 && isHopeless(tried, done, length)) {
            int entry = tolerance.getWorstEntry();
            throw source.failure(entry,
                    "given up after " + tried + " sub-steps, " + done + " s from the beginning, where"
                    + " entry " + entry + " of the state demands sub-steps of " + subStep + " s",
                    "the system is stiff (take an implicit solver), or deltaT is too long or the tolerance too small");
        }
    }

    /** Whether too many sub-steps would be tried, even if the next ones grow as the last ones did. */
    private boolean isHopeless(int tried, double done, double length) {
        double headway = done - (tried == 0 ? 0 : windowBegin);
        double growth = Math.max(1, headway / lastHeadway);     // shorter ones may be followed by longer ones
        double reach = done;
        double next = headway;
        for (int later = tried; later < MOST_SUB_STEPS; later += WINDOW) {
            next *= growth;
            reach += next;
        }
        windowBegin = done;
        lastHeadway = headway;
        return tried > WINDOW && reach < length;
    }

    @Override
    public final void reset() {
        lastStep.forget();
    }
}
