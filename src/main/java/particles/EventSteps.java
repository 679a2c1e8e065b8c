package particles;

import deSolvers.DESolver;
import deSolvers.DESolverException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Makes a run's steps, each from event to event: a motion that an event ends is taken back to it, the event happens,
 * and the rest of the step begins there.
 */
final class EventSteps {
    /** Far more than any sequence of ever smaller bounces has before it ends in rest. */
    private static final int MOST_EVENTS = 100_000;
    /** Of a step: less than any turn needs that is not a stop. */
    private static final double SHORTEST_PIECE = 0x1p-40;

    private final ParticleSystem system;
    private final DESolver solver;
    private final Observers observers;
    private final List<EventRule> rules = new ArrayList<>();
    private final Motion motion = new Motion();
    private EventLocator locator;
    private long events;

    /**
     * @param system   what moves
     * @param solver   what moves it
     * @param observers is told of all motions but the last of a step, and of every event
     */
    EventSteps(ParticleSystem system, DESolver solver, Observers observers) {
        this.system = system;
        this.solver = solver;
        this.observers = observers;
    }

    /** Adds a rule whose events end motions; they are looked for by a solver that is used for nothing else. */
    void addRule(EventRule rule, DESolver searchSolver) {
        rules.add(rule);
        if (locator == null) {
            locator = new EventLocator(searchSolver);
        }
    }

    /** Whether a step may have events: its motions are then always noted down. */
    boolean areLookedFor() {
        return !rules.isEmpty();
    }

    /** The last motion, where it was noted down. */
    Motion getMotion() {
        return motion;
    }

    /** How many events happened so far. */
    long getEvents() {
        return events;
    }

    /**
     * Moves the system by a step. Where the solver fails because the way may turn sharply ahead, it is taken in shorter
     * pieces; where it may not, the failure is the solver's or the step's, and is said.
     *
     * @param h     the length of the step (s)
     * @param noted whether to note its motion down
     * @return whether the last motion was noted down
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
                rules.forEach(rule -> rule.beforeStep(system));
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

    /** Moves by h, or to the first event before that, and tells which. */
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

    /** Takes the present motion back to its first event, if it has any, and lets the event happen there. */
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
