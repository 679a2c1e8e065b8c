package particles;

import deSolvers.DESolver;
import deSolvers.text.Digits;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import particles.SimulationException.End;

/**
 * Makes the steps of a run and splits them at events: a motion with an event is moved back to it, the event acts, and
 * the rest of the step begins there.
 */
final class EventSteps {
    /** The largest number of events in a step: far more than any sequence of ever smaller bounces before rest. */
    private static final int MOST_EVENTS = 100_000;
    /**
     * The largest number of evaluations in a step near a sharp turn of the path. A particle that creeps, because
     * springs pull it only just harder than friction holds it, is stiff for every explicit solver.
     */
    private static final int MOST_EVALUATIONS = 1_000_000;
    /** Parts of a step that are at least this long are too few to go on for ever (relative to deltaT). */
    private static final double LONG_PART = 0x1p-6;
    /** After this number of events in a step, and some more for each particle, its progress is checked. */
    private static final int FEW_EVENTS = 100;
    private static final int FEW_EVENTS_OF_EACH = 5;
    /** Events at a steady rate cover as much time as before; ever smaller bounces cover less. */
    private static final double STEADY = 0.95;
    /**
     * The largest number of such windows of events that a step may take: 5,000 events and 250 of each particle. A
     * jelly of 27 particles on a rough ball has up to 990 events in a step, 37 of each.
     */
    private static final int MOST_WINDOWS = 50;

    private final ParticleSystem system;
    private final double deltaT;
    private final DESolver solver;
    private final Supplier<DESolver> searchSolver;
    private final List<Observer> observers;
    private final List<EventRule> rules = new ArrayList<>();
    private final Motion motion = new Motion();
    private EventLocator locator;
    private long events;
    private long begun;                                 // evaluations before the step
    private double stepEnd;
    private Headway headway;
    private int inStep;                                 // events and parts

    /**
     * @param system       the system
     * @param deltaT       the time step (s)
     * @param solver       its solver
     * @param searchSolver makes another solver, which only locates events
     * @param observers    told of every event and of all motions but the last one of a step; the list may grow
     */
    EventSteps(ParticleSystem system, double deltaT, DESolver solver, Supplier<DESolver> searchSolver,
            List<Observer> observers) {
        this.system = system;
        this.deltaT = deltaT;
        this.solver = solver;
        this.searchSolver = searchSolver;
        this.observers = observers;
    }

    void addRule(EventRule rule) {
        rules.add(rule);
        if (locator == null) {
            locator = new EventLocator(searchSolver.get());
        }
    }

    /** Whether a part of a step at which the solver fails may be made in two halves; its length in s. */
    boolean mayDivide(double length) {
        return rules.stream().anyMatch(rule -> rule.mayDivide(length, deltaT));
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
     * Begins a step, or the part of one up to the next known time at which a rule acts; its work and its events are
     * limited, also where it is divided.
     *
     * @param end the time at its end (s)
     */
    void begin(double end) {
        begun = system.getEvaluations();
        stepEnd = end;
        headway = new Headway(system.getParticles().count(), system.getTime());
        inStep = 0;
    }

    /**
     * Makes one step, or a part of one.
     *
     * @param h     its length (s)
     * @param end   the time at its end, of which the clock plus h may be off by round-off (s)
     * @param noted whether to record its motion
     * @return whether the last motion was recorded
     */
    boolean move(double h, double end, boolean noted) {
        boolean note = noted;
        double left = h;
        while (inStep <= MOST_EVENTS) {
            headway.require(inStep++, system.getTime(), stepEnd);
            if (system.getEvaluations() - begun > MOST_EVALUATIONS
                    && mayDivide(Math.min(left, LONG_PART * deltaT))) {
                throw noHeadway(system.getTime(), "this step took " + (system.getEvaluations() - begun)
                        + " evaluations", stepEnd);
            }
            if (!moveOn(left, end, note)) {
                return note;
            }
            note = true;
            left = end - system.getTime();
        }
        throw noHeadway(system.getTime(), "this step had " + MOST_EVENTS + " impacts or changes of contact", stepEnd);
    }

    private static SimulationException noHeadway(double time, String why, double end) {
        return new SimulationException(End.NO_HEADWAY, time, -1, "contacts make no headway: " + why + ", and "
                + Digits.few(end - time) + " s of the step are left");
    }

    /** Moves by h to a time, or to the first event before that; returns whether an event ended it. */
    private boolean moveOn(double h, double end, boolean note) {
        if (note) {
            motion.begin(system);
        }
        solver.stepState(system, h);
        system.setTime(end);
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
            motion.showTo(observers);
        }
        first.get().event().action().run();
        solver.reset();
        observers.forEach(observer -> observer.changed(system, first.get().rule()));
        return true;
    }

    /**
     * Detects a step that makes no progress. Ever smaller bounces cover less time from one event to the next, and many
     * particles may strike at once; but a contact that opens and closes again and again, as it may between springs with
     * damping, can go on with events a billionth of a step apart.
     */
    private static final class Headway {
        private final int window;
        private double windowStart;
        private double before;

        Headway(int particles, double start) {
            window = FEW_EVENTS + FEW_EVENTS_OF_EACH * particles;
            windowStart = start;
        }

        /** Compares the last window of events with the one before it and with the rest of the step. */
        void require(int events, double time, double end) {
            if (events == 0 || events % window != 0) {
                return;
            }
            double covered = time - windowStart;
            if (events > window && covered >= STEADY * before && end - time > MOST_WINDOWS * covered) {
                throw noHeadway(time, "the last " + window + " impacts or changes of contact cover "
                        + Digits.few(covered) + " s", end);
            }
            before = covered;
            windowStart = time;
        }
    }
}
