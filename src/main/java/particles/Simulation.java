package particles;

import deSolvers.DESolver;
import deSolvers.DESolverException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.function.Predicate;
import java.util.function.Supplier;
import particles.law.Particles;
import particles.law.Require;
import particles.law.Violation;

/**
 * The simulation loop. Until the duration is over, it tells the rules that a step begins, makes the step, shows it to
 * the observers that want it and applies the rules. Steps are counted: the k-th ends k deltaT after the start, and the
 * last one, which may be shorter, at the end.
 */
public final class Simulation {
    /** Times that differ by this fraction of deltaT are the same, but for round-off. */
    private static final double ROUNDING = 1e-6;
    /** The largest violation of a constraint in a run, relative to its scale. */
    private static final double WRONG = 0.1;

    private final ParticleSystem system;
    private final DESolver solver;
    private final double deltaT;
    private final double duration;
    private final List<Rule> rules = new ArrayList<>();
    private final List<Observer> observers = new ArrayList<>();
    private final ConstraintCheck constraints;
    private final EventSteps eventSteps;
    private double startTime;
    private long planned;                               // steps
    private long before;                                // steps before it was prolonged
    private long steps;
    private long divisions;

    /**
     * @param system      the system
     * @param solver      makes its solver, and another one that locates events: its trial steps must not disturb the
     *                    memory of the run's own
     * @param deltaT      the time step (s), positive; a run that is shorter makes one step of its duration
     * @param duration    the duration of the run, from the system's present time (s), 0 or more
     * @throws IllegalArgumentException if a number is out of its range
     */
    public Simulation(ParticleSystem system, Supplier<DESolver> solver, double deltaT, double duration) {
        this.system = system;
        this.solver = solver.get();
        this.duration = Require.notNegative("the duration", duration);
        this.deltaT = Math.min(Require.positive("deltaT", deltaT), duration > 0 ? duration : deltaT);
        this.eventSteps = new EventSteps(system, this.deltaT, this.solver, solver, observers);
        constraints = new ConstraintCheck(this.deltaT * (1 + ROUNDING), duration);
        observers.add(constraints);
    }

    /**
     * Adds a rule. An {@link EventRule} also divides a step at the exact times of events such as impacts.
     *
     * @param rule called before and after every step; rules act in the order in which they were added
     */
    public void addRule(Rule rule) {
        rules.add(rule);
        if (rule instanceof EventRule withEvents) {
            eventSteps.addRule(withEvents);
        }
    }

    /**
     * Returns the rules.
     *
     * @return the rules in the order in which they act; read only
     */
    public List<Rule> getRules() {
        return Collections.unmodifiableList(rules);
    }

    /**
     * Adds an observer.
     *
     * @param observer called after the observers added earlier
     */
    public void addObserver(Observer observer) {
        observers.add(observer);
    }

    /**
     * Runs to the end.
     *
     * @throws SimulationException as in {@link #advance()}
     */
    public void run() {
        start();
        while (!isOver()) {
            advance();
        }
        finish();
    }

    /** Tells rules and observers that the run begins; call it once, before {@link #advance()}. */
    public void start() {
        startTime = system.getTime();
        planned = duration > 0 ? Math.max(1, (long) Math.ceil(duration / deltaT - ROUNDING)) : 0;
        try {
            rules.forEach(rule -> rule.start(system));
        } finally {                                     // also of a run that fails here, observers have the beginning
            observers.forEach(observer -> observer.started(system));
        }
    }

    /**
     * Tells whether the run has reached its end.
     *
     * @return whether the duration is over
     */
    public boolean isOver() {
        return steps - before >= planned;
    }

    /** Lets a run that is over go on for its duration once more. */
    public void prolong() {
        startTime = system.getTime();
        before = steps;
    }

    /**
     * Makes one step.
     *
     * @throws SimulationException if the solver fails, as on NaN or without convergence; if the energy exceeds an
     *         {@link EnergyLimit}; if impacts follow each other without end, or deltaT is too small to move the clock;
     *         if a rod, wire or contact is seen to be violated by more than a tenth of its scale. Observers keep the
     *         results so far; {@link #finish} need not be called
     */
    public void advance() {
        long next = steps - before + 1;
        double end = startTime + (next < planned ? next * deltaT : duration);
        if (end <= system.getTime()) {
            throw new SimulationException(system.getTime(), -1,
                    "a step of " + deltaT + " s no longer moves the clock at"
                    + " t = " + system.getTime(), null);
        }
        advanceTo(end);
        requireRight(constraints.getWorst());
    }

    /**
     * Tells observers that the run is over.
     *
     * @throws SimulationException if a rod, wire or contact was violated by more than a tenth of its scale, or the
     *         reported work of moving anchors is wrong by that: then the motion is wrong, whatever its energy says
     */
    public void finish() {
        observers.forEach(observer -> observer.finished(system));
        requireRight(getViolation());
    }

    private void requireRight(Violation violation) {
        if (violation.part() > WRONG) {
            throw new SimulationException(SimulationException.End.NUMERICAL_ERROR, system.getTime(), -1,
                    violation.what() + ": the motion is wrong");
        }
    }

    /** @return the largest violation of a rod, wire or contact in the run, or overlap of hard balls at present */
    public Violation getViolation() {
        Violation worst = constraints.getWorst(system);
        for (Rule rule : rules) {
            worst = worst.or(rule.getViolation(system));
        }
        return worst;
    }

    /** Makes a step; in shorter ones if rules act at known times within it. */
    private void advanceTo(double end) {
        double rounding = ROUNDING * deltaT;
        for (double next = nextAction(); next < end - rounding; next = nextAction()) {
            double now = system.getTime() + rounding;
            if (next > now) {
                eventSteps.begin(next);
                step(next, 0);
            } else {
                act(deltaT, rule -> rule.getNextTime() <= now);
            }
        }
        eventSteps.begin(end);
        step(end, 1);
    }

    private double nextAction() {
        double next = Double.POSITIVE_INFINITY;
        for (Rule rule : rules) {
            next = Math.min(next, rule.getNextTime());
        }
        return next;
    }

    /**
     * Makes one step that counts as this many. A step as long as deltaT but for round-off is exactly that long. Where
     * the solver fails and a rule allows it, what is left of the step is made in two halves, each as a step of its own.
     */
    private void step(double end, int counted) {
        double left = end - system.getTime();
        double h = Math.abs(left - deltaT) <= ROUNDING * deltaT ? deltaT : left;
        for (Rule rule : rules) {
            rule.beforeStep(system, h);
        }
        // a motion is the path within a step; it is recorded only if an event search or an observer needs it
        boolean recordMotion = eventSteps.areLookedFor() || isAwaited(end + ROUNDING * deltaT);
        boolean recorded;
        try {
            // calls solver.stepState; in pieces if there are events
            recorded = eventSteps.move(h, end, recordMotion);
        } catch (DESolverException e) {
            double rest = end - system.getTime();       // where the solver failed: after the last event, if any
            double middle = end - rest / 2;
            boolean hasMiddle = system.getTime() < middle && middle < end;  // else the clock is too coarse
            boolean isOfAll = e.getEntry() < 0;         // not of one number, which a blow-up overflows
            if (hasMiddle && isOfAll && eventSteps.mayDivide(rest)) {
                divisions++;
                solver.reset();
                step(middle, 0);
                step(end, counted);
                return;
            }
            int particle = e.getEntry() < 0 ? -1 : e.getEntry() / Particles.STRIDE;
            throw new SimulationException(e.getTime(), particle, e.getMessage(), e);
        }
        steps += counted;
        if (recorded) {
            eventSteps.getMotion().showTo(observers);
        }
        act(h, rule -> true);
    }

    private void act(double h, Predicate<Rule> which) {
        boolean changed = false;
        for (Rule rule : rules) {
            if (which.test(rule) && rule.afterStep(system, h)) {
                changed = true;
                observers.forEach(observer -> observer.changed(system, rule));
            }
        }
        if (changed) {
            solver.reset();
        }
    }

    /** Whether any observer wants to see a motion that ends at this time (s). */
    private boolean isAwaited(double until) {
        for (Observer observer : observers) {           // no stream, since each step asks
            if (observer.getNextTime() <= until) {
                return true;
            }
        }
        return false;
    }

    /** @return the system */
    public ParticleSystem getSystem() {
        return system;
    }

    /** @return the time step (s) */
    public double getDeltaT() {
        return deltaT;
    }

    /** @return the duration of the run (s) */
    public double getDuration() {
        return duration;
    }

    /** @return the number of events located so far */
    public long getEvents() {
        return eventSteps.getEvents();
    }

    /** @return how often a step, or a part of one, was divided since the solver failed at it */
    public long getDivisions() {
        return divisions;
    }

    /** @return the number of steps made so far */
    public long getSteps() {
        return steps;
    }
}
