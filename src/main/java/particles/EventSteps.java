package particles;

import deSolvers.DESolver;
import deSolvers.DESolverException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Makes the steps of a run and splits them at events: a motion with an event is moved back to it, the event acts, and
 * the rest of the step begins there.
 */
final class EventSteps {
    /** Far more than any sequence of ever smaller bounces has before rest. */
    private static final int MOST_EVENTS = 100_000;
    /** The shortest piece to try, as a fraction of a step; any turn that is not a stop needs less precision. */
    private static final double SHORTEST_PIECE = 0x1p-40;

    private final ParticleSystem system;
    private final DESolver solver;
    private final Observers observers;
    private final List<EventRule> rules = new ArrayList<>();
    private final Motion motion = new Motion();
    private EventLocator locator;
    private long events;

    /**
     * @param system   the system
     * @param solver   its solver
     * @param observers told of every event and of all motions but the last one of a step
     */
    EventSteps(ParticleSystem system, DESolver solver, Observers observers) {
        this.system = system;
        this.solver = solver;
        this.observers = observers;
    }

    /** Adds a rule with events; searchSolver is used only to locate them. */
    void addRule(EventRule rule, DESolver searchSolver) {
        rules.add(rule);
        if (locator == null) {
            locator = new EventLocator(searchSolver);
        }
    }

    /** Whether a step may have events; its motions are then always recorded. */
    boolean areLookedFor() {
        return !rules.isEmpty();
    }

    /** The last motion, if it was recorded. */
    Motion getMotion() {
        return motion;
    }

    /** The number of events so far. */
    long getEvents() {
        return events;
    }

    /**
     * Makes one step. If the solver fails where the path may turn sharply, the step is retried in shorter pieces; any
     * other failure is thrown.
     *
     * @param h     the length of the step (s)
     * @param noted whether to record its motion
     * @return whether the last motion was recorded
     */
    boolean move(double h, boolean noted) {
        double end = system.getTime() + h;
        boolean note = noted;
        double left = h;
        double length = h;
        for (int inStep = 0; inStep <= MOST_EVENTS; inStep++) {
            boolean stopped;
            try {
                stopped = moveOn(length, note);
            } catch (DESolverException e) {             // the system is back where the motion began
                if (length < SHORTEST_PIECE * h || !mayTurnWithin(length)) {
                    throw e;
                }
                solver.reset();
                length /= 2;
                continue;
            }
            if (!stopped && length == left) {
                return note;
            }
            if (!stopped) {
                observers.reportMotion(motion);
                solver.reset();
                double rest = end - system.getTime();
                rules.forEach(rule -> rule.beforeStep(system, rest));
            }
            note = true;
            left = end - system.getTime();
            length = left;
        }
        throw new SimulationException(system.getTime(), -1, MOST_EVENTS + " impacts or changes of contact within one"
                + " step of " + h + " s, and no end", null);
    }

    private boolean mayTurnWithin(double time) {
        for (EventRule rule : rules) {
            if (rule.mayTurnWithin(system, time)) {
                return true;
            }
        }
        return false;
    }

    /** Moves by h, or to the first event before that; returns whether an event ended it. */
    private boolean moveOn(double h, boolean note) {
        if (note) {
            motion.begin(system);
        }
        solver.stepState(system, h);
        if (note) {
            motion.end();
        }
        return areLookedFor() && stopAtEvent();
    }

    /** Moves back to the first event of the motion, if it has any, and applies it. */
    private boolean stopAtEvent() {
        Optional<EventLocator.Found> first = locator.locateFirst(system, motion, rules);
        if (first.isEmpty()) {
            return false;
        }
        events++;
        if (motion.getEndTime() > motion.getStartTime()) {
            observers.reportMotion(motion);
        }
        first.get().event().act(system);
        solver.reset();
        observers.reportChange(system, first.get().rule());
        return true;
    }
}
