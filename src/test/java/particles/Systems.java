package particles;

import static org.junit.jupiter.api.Assertions.assertEquals;

import deSolvers.DESolver;
import deSolvers.RK4Solver;
import deSolvers.adaptive.DormandPrinceSolver;
import deSolvers.catalog.SolverCatalog;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import particles.effects.Gravity;
import particles.effects.springs.SpringForce;
import particles.energy.EnergyLedger;
import particles.law.Vector3;

/** Small systems and runs shared by several tests. */
public final class Systems {
    /** Gravity of the reference values (m/s&sup2;), downwards. */
    public static final Vector3 GRAVITY = new Vector3(0, -9.81, 0);

    private Systems() {
    }

    /** @return a system of one particle of mass 1 kg */
    public static ParticleSystem oneParticle(Vector3 position, Vector3 velocity) {
        ParticleSystem system = new ParticleSystem();
        system.addParticle("p", 1, position, velocity, false);
        return system;
    }

    /** @return free particles of 1 kg at rest, 1 m apart on the x axis */
    public static ParticleSystem row(int count) {
        ParticleSystem system = new ParticleSystem();
        for (int i = 0; i < count; i++) {
            system.addParticle("p" + i, 1, new Vector3(i, 0, 0), Vector3.ZERO, false);
        }
        return system;
    }

    /** @return springs that act on the system's particles from now on */
    public static SpringForce springs(ParticleSystem system) {
        SpringForce springs = new SpringForce(system.getParticles());
        system.addEffect(springs);
        return springs;
    }

    /** Lets {@link #GRAVITY} act on the system's particles. */
    public static void addGravity(ParticleSystem system) {
        system.addEffect(new Gravity(system.getParticles(), GRAVITY));
    }

    /** Runs to the end without an energy limit; returns the energies booked. */
    public static EnergyLedger ledger(ParticleSystem system, DESolver solver, double deltaT, double duration,
            Rule... rules) {
        EnergyLedger ledger = new EnergyLedger();
        Simulation simulation = simulation(system, solver, deltaT, duration, rules);
        simulation.addObserver(ledger);
        simulation.run();
        return ledger;
    }

    /** @return a run by rk4 without an energy limit */
    public static Simulation rk4(ParticleSystem system, double deltaT, double duration) {
        return new Simulation(system, RK4Solver::new, deltaT, duration);
    }

    /** Runs to the end, with rules and no energy limit. */
    public static Simulation run(ParticleSystem system, DESolver solver, double deltaT, double duration,
            Rule... rules) {
        Simulation simulation = simulation(system, solver, deltaT, duration, rules);
        simulation.run();
        return simulation;
    }

    private static Simulation simulation(ParticleSystem system, DESolver solver, double deltaT, double duration,
            Rule... rules) {
        Simulation simulation = new Simulation(system, () -> solver, deltaT, duration);
        List.of(rules).forEach(simulation::addRule);
        return simulation;
    }

    /** @return an observer that is told of every motion */
    public static Observer onMove(Consumer<Motion> look) {
        return new Observer() {
            @Override
            public void moved(Motion motion) {
                look.accept(motion);
            }
        };
    }

    /** @return a rule that acts after each step, and says whether it changed anything */
    public static Rule afterStep(Predicate<ParticleSystem> act) {
        return new Rule() {
            @Override
            public String getName() {
                return "test";
            }

            @Override
            public boolean afterStep(ParticleSystem system, double deltaT) {
                return act.test(system);
            }
        };
    }

    /** Requires that every fixed-step solver has its order, as {@link #order} measures it. */
    public static void assertOrders(Supplier<ParticleSystem> start, double duration, int steps, double within) {
        SolverCatalog.all().stream().filter(solver -> !solver.adaptive()).forEach(solver -> assertEquals(
                solver.order(), order(start, solver.name(), duration, steps), within, solver.name()));
    }

    /**
     * @param start makes the system at its start
     * @param name  a fixed-step solver
     * @param steps a number of steps whose errors are not round-off
     * @return the order measured from the errors of the state after this time, with these steps and with twice as many
     */
    public static double order(Supplier<ParticleSystem> start, String name, double duration, int steps) {
        double[] exact = end(start, new DormandPrinceSolver(1e-13, 1e-13), duration, 1);
        double coarse = largestDifference(exact, end(start, SolverCatalog.create(name), duration, steps));
        double fine = largestDifference(exact, end(start, SolverCatalog.create(name), duration, 2 * steps));
        return Math.log(coarse / fine) / Math.log(2);
    }

    private static double[] end(Supplier<ParticleSystem> start, DESolver solver, double duration, int steps) {
        ParticleSystem system = start.get();
        for (int step = 0; step < steps; step++) {
            solver.stepState(system, duration / steps);
        }
        return system.getOwnState();
    }

    private static double largestDifference(double[] a, double[] b) {
        return IntStream.range(0, a.length).mapToDouble(k -> Math.abs(a[k] - b[k])).max().orElseThrow();
    }

    /** @return entry k of the system's state: 0, 1, 2 position of the first particle, 3, 4, 5 its velocity */
    public static double entry(ParticleSystem system, int k) {
        return system.getOwnState()[k];
    }
}
