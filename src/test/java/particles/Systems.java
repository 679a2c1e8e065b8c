package particles;

import deSolvers.DESolver;
import deSolvers.RK4Solver;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Predicate;
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

    /** @return entry k of the system's state: 0, 1, 2 position of the first particle, 3, 4, 5 its velocity */
    public static double entry(ParticleSystem system, int k) {
        return system.getOwnState()[k];
    }
}
