package particles;

import deSolvers.DESolver;
import deSolvers.DESolverException;
import java.util.ArrayList;
import java.util.List;

/**
 * The loop: step, rules, check, observers, until the duration is over. The last step is shortened so that the run ends at
 * its duration.
 */
public final class Simulation {
    /** A last step longer than deltaT by no more than this part of it is rounding of the clock, not a step too many. */
    private static final double ROUNDING = 1e-6;

    private final ParticleSystem system;
    private final DESolver solver;
    private final double deltaT;
    private final double duration;
    private final double energyLimit;
    private final List<Rule> rules = new ArrayList<>();
    private final List<Observer> observers = new ArrayList<>();
    private final Motion motion = new Motion();
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
        if (!(energyLimit > 0)) {
            throw new IllegalArgumentException("the energy limit has to be positive, not " + energyLimit);
        }
        this.system = system;
        this.solver = solver;
        this.deltaT = deltaT;
        this.duration = duration;
        this.energyLimit = energyLimit;
    }

    /** @param rule to act after every step, after those added before */
    public void addRule(Rule rule) {
        rules.add(rule);
    }

    /** @param observer to be told of every step */
    public void addObserver(Observer observer) {
        observers.add(observer);
    }

    /**
     * Runs to the end.
     *
     * @throws SimulationException if the numbers stop being finite or the energy passes its limit; what observers saw
     *                             until then stands
     */
    public void run() {
        double endTime = system.getTime() + duration;
        for (Rule rule : rules) {
            rule.start(system);
        }
        for (Observer observer : observers) {
            observer.started(system);
        }
        double left = duration;
        while (left > ROUNDING * deltaT) {
            double before = left;
            step(left <= deltaT * (1 + ROUNDING) ? left : deltaT);
            left = endTime - system.getTime();
            if (left >= before) {
                throw new SimulationException(system.getTime(), -1, "a step of " + deltaT + " s no longer moves the clock at t = "
                        + system.getTime(), null);
            }
        }
        for (Observer observer : observers) {
            observer.finished(system);
        }
    }

    private void step(double h) {
        for (Rule rule : rules) {
            rule.beforeStep(system);
        }
        boolean observed = isAnyoneInterested(system.getTime() + h);
        if (observed) {
            motion.begin(system);
        }
        try {
            solver.stepState(system, h);
        } catch (DESolverException e) {
            int particle = e.getEntry() < 0 ? -1 : e.getEntry() / Particles.STRIDE;
            throw new SimulationException(e.getTime(), particle, e.getMessage(), e);
        }
        steps++;
        if (observed) {
            motion.end();
            for (Observer observer : observers) {
                if (observer.getNextTime() <= motion.getEndTime()) {
                    observer.moved(motion);
                }
            }
        }
        boolean changed = false;
        for (Rule rule : rules) {
            changed |= rule.afterStep(system, h);
        }
        if (changed) {
            solver.reset();
            for (Observer observer : observers) {
                observer.changed(system);
            }
        }
        checkEnergy();
    }

    private boolean isAnyoneInterested(double until) {
        for (Observer observer : observers) {
            if (observer.getNextTime() <= until + ROUNDING * deltaT) {
                return true;
            }
        }
        return false;
    }

    /** Blow-up shows in the kinetic energy within a step or two, and that is cheap to add up. */
    private void checkEnergy() {
        double[] state = system.getOwnState();
        double energy = system.getKineticEnergy(state);
        if (energy <= energyLimit) {
            return;
        }
        int fastest = fastest(state);
        throw new SimulationException(system.getTime(), fastest, "the kinetic energy is " + energy + " J, beyond the limit of "
                + energyLimit + " J; the fastest particle is '" + system.getParticles().id(fastest) + "'", null);
    }

    private int fastest(double[] state) {
        int fastest = 0;
        double most = -1;
        for (int i = 0, v = 3; i < system.getParticles().count(); i++, v += Particles.STRIDE) {
            double square = state[v] * state[v] + state[v + 1] * state[v + 1] + state[v + 2] * state[v + 2];
            if (!system.getParticles().isFixed(i) && !(square <= most)) {
                most = square;
                fastest = i;
            }
        }
        return fastest;
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
        return energyLimit;
    }

    /** @return how many steps were made so far */
    public long getSteps() {
        return steps;
    }
}
