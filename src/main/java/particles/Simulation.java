package particles;

import deSolvers.DESolver;
import deSolvers.DESolverException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import particles.law.Particles;

/**
 * The loop: step, rules, check, observers, until the duration is over. The last step is shortened so that the run ends
 * at its duration.
 */
public final class Simulation {
    /** A last step longer than deltaT by no more than this part of it is rounding of the clock, not a step too many. */
    private static final double ROUNDING = 1e-6;

    private final ParticleSystem system;
    private final DESolver solver;
    private final double deltaT;
    private final double duration;
    private final EnergyLimit energyLimit;
    private final List<Rule> rules = new ArrayList<>();
    private final List<Observer> observers = new ArrayList<>();
    private final Observers audience = new Observers(observers);
    private final EventSteps eventSteps;
    private double endTime;
    private long steps;

    /**
     * @param system      what moves
     * @param solver      what moves it
     * @param deltaT      the time step (s), positive
     * @param duration    how long the run lasts, from the system's present time (s), 0 or more
     * @param energyLimit the kinetic energy beyond which the run has blown up (J), positive; may be infinite
     * @throws IllegalArgumentException if a number is out of its range
     */
    public Simulation(ParticleSystem system, DESolver solver, double deltaT, double duration, double energyLimit) {
        if (!(deltaT > 0) || !(deltaT <= Double.MAX_VALUE)) {
            throw new IllegalArgumentException("deltaT has to be positive and finite, not " + deltaT);
        }
        if (!(duration >= 0) || !(duration <= Double.MAX_VALUE)) {
            throw new IllegalArgumentException("the duration has to be 0 or more and finite, not " + duration);
        }
        this.system = system;
        this.solver = solver;
        this.deltaT = deltaT;
        this.duration = duration;
        this.energyLimit = new EnergyLimit(energyLimit);
        this.eventSteps = new EventSteps(system, solver, audience);
    }

    /** @param rule to act after every step, after those added before */
    public void addRule(Rule rule) {
        rules.add(rule);
    }

    /**
     * Adds a rule that acts inside steps too.
     *
     * @param rule         to act at its events, and after every step like any other rule
     * @param searchSolver a solver of the same kind as the run's and used for nothing else, for the search of event
     *                     times
     */
    public void addEventRule(EventRule rule, DESolver searchSolver) {
        rules.add(rule);
        eventSteps.addRule(rule, searchSolver);
    }

    /** @return the rules, in the order in which they act; to be read only */
    public List<Rule> getRules() {
        return Collections.unmodifiableList(rules);
    }

    /** @param observer to be told of every step */
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

    /** Tells rules and observers that the first step is about to come; once, before {@link #advance()}. */
    public void start() {
        endTime = system.getTime() + duration;
        rules.forEach(rule -> rule.start(system));
        observers.forEach(observer -> observer.started(system));
    }

    /** @return whether the duration is over */
    public boolean isOver() {
        return endTime - system.getTime() <= ROUNDING * deltaT;
    }

    /**
     * Makes one step.
     *
     * @throws SimulationException if the numbers stop being finite or the energy passes its limit; what observers saw
     *                             until then stands
     */
    public void advance() {
        double left = endTime - system.getTime();
        step(left <= deltaT * (1 + ROUNDING) ? left : deltaT);
        if (endTime - system.getTime() >= left) {
            throw new SimulationException(system.getTime(), -1,
                    "a step of " + deltaT + " s no longer moves the clock at"
                    + " t = " + system.getTime(), null);
        }
    }

    /** Tells observers that the last step was made. */
    public void finish() {
        observers.forEach(observer -> observer.finished(system));
    }

    private void step(double h) {
        for (Rule rule : rules) {
            rule.beforeStep(system);
        }
        double end = system.getTime() + h;
        boolean observed = eventSteps.areLookedFor() || audience.isInterested(end + ROUNDING * deltaT);
        try {
            observed = eventSteps.move(h, observed);
        } catch (DESolverException e) {
            int particle = e.getEntry() < 0 ? -1 : e.getEntry() / Particles.STRIDE;
            throw new SimulationException(e.getTime(), particle, e.getMessage(), e);
        }
        steps++;
        if (observed) {
            audience.reportMotion(eventSteps.getMotion());
        }
        boolean changed = false;
        for (Rule rule : rules) {
            if (rule.afterStep(system, h)) {
                changed = true;
                audience.reportChange(system, rule);
            }
        }
        if (changed) {
            solver.reset();
        }
        energyLimit.check(system);
    }

    /** @return the system */
    public ParticleSystem getSystem() {
        return system;
    }

    /** @return the time step (s) */
    public double getDeltaT() {
        return deltaT;
    }

    /** @return how long the run lasts (s) */
    public double getDuration() {
        return duration;
    }

    /** @return the kinetic energy beyond which the run has blown up (J) */
    public double getEnergyLimit() {
        return energyLimit.joules();
    }

    /** @return how many events were located so far */
    public long getEvents() {
        return eventSteps.getEvents();
    }

    /** @return how many steps were made so far */
    public long getSteps() {
        return steps;
    }
}
