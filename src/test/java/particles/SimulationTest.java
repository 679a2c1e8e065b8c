package particles;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Systems.GRAVITY;
import static particles.Systems.oneParticle;
import static particles.Systems.run;

import deSolvers.DESolver;
import deSolvers.DEStateSource;
import deSolvers.EulerSolver;
import deSolvers.RK4Solver;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import particles.effects.Gravity;
import particles.effects.springs.SpringForce;
import particles.law.Vector3;

/** The simulation loop: its end, its calls of observers and rules, and when it gives up. */
class SimulationTest {

    private static ParticleSystem swinging() {
        ParticleSystem system = new ParticleSystem();
        int pivot = system.addParticle("pivot", 1, Vector3.ZERO, Vector3.ZERO, true);
        int bob = system.addParticle("bob", 2, new Vector3(1.2, 0, 0.3), Vector3.ZERO, false);
        SpringForce spring = new SpringForce(system.getParticles());
        spring.addSpring(pivot, bob, 50, 1, 0);
        system.addEffect(spring);
        system.addEffect(new Gravity(system.getParticles(), GRAVITY));
        return system;
    }

    @ParameterizedTest
    @CsvSource({"0.1, 1, 10", "0.01, 1, 100", "0.3, 1, 4", "1, 0.25, 1", "0.001, 10, 10000", "0.1, 0, 0",
            "0.25, 1e6, 4000000"})
    void theRunEndsAtItsDuration(double deltaT, double duration, long steps) {
        ParticleSystem system = new ParticleSystem();
        Simulation simulation = run(system, new EulerSolver(), deltaT, duration);
        assertEquals(duration, system.getTime(), Math.ulp(duration));
        assertEquals(steps, simulation.getSteps());
    }

    @Test
    void aStepThatNoLongerMovesTheClockEndsTheRun() {
        ParticleSystem system = oneParticle(Vector3.ZERO, Vector3.ZERO);
        system.incTime(1e20);
        SimulationException e = assertThrows(SimulationException.class, () -> run(system, new EulerSolver(), 0.1, 1e6));
        assertTrue(e.getMessage().contains("no longer moves the clock"), e.getMessage());
    }

    /** Observers of all steps, of rare times and of none: the same bits, and each is called when it asked to be. */
    @Test
    void observersSeeWhatTheyAskForAndChangeNothing() {
        ParticleSystem alone = swinging();
        run(alone, new RK4Solver(), 0.01, 2.005);
        ParticleSystem observed = swinging();
        Simulation simulation = new Simulation(observed, RK4Solver::new, 0.01, 2.005);
        List<Double> every = new ArrayList<>();
        List<Double> rare = new ArrayList<>();
        simulation.addObserver(new Observer() {
            @Override
            public void moved(Motion motion) {
                every.add(motion.getEndTime() - motion.getStartTime());
            }
        });
        simulation.addObserver(new Observer() {
            @Override
            public double getNextTime() {
                return 0.5 * (1 + rare.size());
            }

            @Override
            public void moved(Motion motion) {
                rare.add(motion.getEndTime());
                assertTrue(motion.getStartTime() < 0.5 * rare.size() + 1e-9);
            }
        });
        simulation.run();
        assertArrayEquals(alone.getOwnState(), observed.getOwnState());
        assertEquals(alone.getEvaluations(), observed.getEvaluations());
        assertEquals(201, every.size());
        assertEquals(0.005, every.get(200), 1e-12, "the last step is shortened");
        assertEquals(4, rare.size());
    }

    /** Free fall is a parabola, which the cubic through positions and velocities meets exactly. */
    @Test
    void interpolatedFramesLieOnTheParabola() {
        ParticleSystem system = oneParticle(new Vector3(1, 2, 3), new Vector3(4, 5, 6));
        system.addEffect(new Gravity(system.getParticles(), GRAVITY));
        Simulation simulation = new Simulation(system, RK4Solver::new, 0.25, 1);
        simulation.addObserver(new Observer() {
            @Override
            public void moved(Motion motion) {
                double[] between = new double[6];
                for (double t = motion.getStartTime(); t <= motion.getEndTime(); t += 0.0625) {
                    motion.interpolate(t, between);
                    assertEquals(1 + 4 * t, between[0], 1e-14);
                    assertEquals(2 + 5 * t - 9.81 * t * t / 2, between[1], 1e-14);
                    assertEquals(5 - 9.81 * t, between[4], 1e-13);
                    assertEquals(6, between[5], 1e-13);
                }
            }
        });
        simulation.run();
    }

    @Test
    void rulesActAfterTheStepAndTheSolverIsTold() {
        List<String> calls = new ArrayList<>();
        DESolver solver = new DESolver() {
            @Override
            public void stepState(DEStateSource source, double deltaT) {
                source.incTime(deltaT);
                calls.add("step");
            }

            @Override
            public void reset() {
                calls.add("reset");
            }
        };
        Rule everySecond = new Rule() {
            private int steps;

            @Override
            public String getName() {
                return "every second";
            }

            @Override
            public void beforeStep(ParticleSystem system, double deltaT) {
                calls.add("before");
            }

            @Override
            public boolean afterStep(ParticleSystem system, double deltaT) {
                calls.add("after");
                return ++steps % 2 == 0;
            }
        };
        run(new ParticleSystem(), solver, 1, 2, everySecond);
        assertEquals(List.of("before", "step", "after", "before", "step", "after", "reset"), calls);
    }

    /** h omega = 3 with Euler: the energy grows tenfold a step, and the run stops above the limit, not before. */
    @Test
    void blowUpEndsTheRun() {
        ParticleSystem system = new ParticleSystem();
        int a = system.addParticle("a", 1, Vector3.ZERO, Vector3.ZERO, true);
        int b = system.addParticle("b", 1, new Vector3(1.1, 0, 0), Vector3.ZERO, false);
        SpringForce spring = new SpringForce(system.getParticles());
        spring.addSpring(a, b, 9, 0, 0);
        system.addEffect(spring);
        Simulation simulation = new Simulation(system, EulerSolver::new, 1, 100);
        simulation.addRule(new EnergyLimit(1e6));
        SimulationException e = assertThrows(SimulationException.class, simulation::run);
        assertEquals(1, e.getParticle());
        assertTrue(e.getMessage()
                .matches("the kinetic energy is [\\d.e]+ J, above the limit of 1000000 J;"
                + " the fastest particle is 'b'"), e.getMessage());
        assertTrue(simulation.getSteps() >= 5 && simulation.getSteps() <= 8, "steps: " + simulation.getSteps());
    }

    @Test
    void aNumberThatIsNotFiniteEndsTheRunWithItsParticle() {
        ParticleSystem system = new ParticleSystem();
        system.addParticle("calm", 1, Vector3.ZERO, Vector3.ZERO, false);
        system.addParticle("wild", 1, Vector3.ZERO, new Vector3(0, 1e308, 0), false);
        SimulationException e = assertThrows(SimulationException.class, () -> run(system, new EulerSolver(), 10, 100));
        assertEquals(1, e.getParticle());
        assertTrue(e.getMessage().contains("EulerSolver at t = 0.0"), e.getMessage());
    }

    @Test
    void invalidParticlesAndRunsAreRefused() {
        ParticleSystem system = new ParticleSystem();
        for (double mass : new double[] {0, -1, Double.NaN, Double.POSITIVE_INFINITY, 1e-320}) {
            assertThrows(IllegalArgumentException.class, () -> system.addParticle("p", mass, Vector3.ZERO, Vector3.ZERO,
                    false));
        }
        Vector3 nowhere = new Vector3(Double.NaN, 0, 0);
        assertThrows(IllegalArgumentException.class, () -> system.addParticle("p", 1, nowhere, Vector3.ZERO, false));
        assertThrows(IllegalArgumentException.class, () -> system.addParticle("p", 1, Vector3.ZERO, nowhere, false));
        assertThrows(IllegalArgumentException.class, () -> system.addParticle("p", 1, Vector3.ZERO,
                new Vector3(1, 0, 0), true));
        assertEquals(0, system.getStateSize());
        for (double bad : new double[] {0, -1, Double.NaN, Double.POSITIVE_INFINITY}) {
            assertThrows(IllegalArgumentException.class, () -> new Simulation(system, EulerSolver::new, bad, 1));
        }
        assertThrows(IllegalArgumentException.class, () -> new Simulation(system, EulerSolver::new, 1, -1));
        assertThrows(IllegalArgumentException.class, () -> new EnergyLimit(Double.NaN));
    }

    @Test
    void theStateIsInterleavedAndTheDerivativeIsVelocityAndForceOverMass() {
        ParticleSystem system = new ParticleSystem();
        system.addParticle("a", 2, new Vector3(1, 2, 3), new Vector3(4, 5, 6), false);
        system.addParticle("b", 2, new Vector3(7, 8, 9), Vector3.ZERO, true);
        system.addEffect(new Gravity(system.getParticles(), GRAVITY));
        double[] state = new double[12];
        system.getState(state);
        assertArrayEquals(new double[] {1, 2, 3, 4, 5, 6, 7, 8, 9, 0, 0, 0}, state);
        double[] dSdt = new double[12];
        system.getStateDerivative(dSdt);
        assertArrayEquals(new double[] {4, 5, 6, 0, -9.81, 0, 0, 0, 0, 0, 0, 0}, dSdt, 1e-300);
        assertEquals(77, system.getKineticEnergy(state));
        assertEquals(77 + 2 * 9.81 * 2, system.getEnergy(state, 0), 1e-12,
                "the fixed particle's height does not count");
    }
}
