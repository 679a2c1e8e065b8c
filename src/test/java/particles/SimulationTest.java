package particles;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Systems.addGravity;
import static particles.Systems.onMove;
import static particles.Systems.oneParticle;
import static particles.Systems.run;

import deSolvers.DESolver;
import deSolvers.DEStateSource;
import deSolvers.EulerSolver;
import deSolvers.problems.Steps;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import particles.energy.EnergyHistory;
import particles.law.Vector3;
import particles.scene.Scene;
import particles.scene.SceneBuilder;
import particles.scene.ShortRun;
import particles.scene.TestScenes;

/** The simulation loop: its end, its calls of observers and rules, and when it gives up. */
class SimulationTest {

    private static Scene swinging() {
        return TestScenes.build("""
                title: A swing
                teaches: The loop.
                solver: rk4
                deltaT: 0.01
                duration: 2.005
                particles: [{id: pivot, position: [0, 0, 0], fixed: true}, {id: bob, position: [1.2, 0, 0.3], mass: 2}]
                springs: [{from: pivot, to: bob, stiffness: 50, restLength: 1}]
                effects: [gravity]
                """);
    }

    @Test
    void aStepThatNoLongerMovesTheClockEndsTheRun() {
        ParticleSystem system = oneParticle(Vector3.ZERO, Vector3.ZERO);
        system.incTime(1e20);
        Steps.assertFails(SimulationException.class, "no longer moves the clock",
                () -> run(system, new EulerSolver(), 0.1, 1e6));
    }

    /** Observers of all steps, of rare times and of none: the same bits, and each is called when it asked to be. */
    @Test
    void observersSeeWhatTheyAskForAndChangeNothing() {
        Scene alone = swinging();
        alone.simulation().run();
        Scene observed = swinging();
        Simulation simulation = observed.simulation();
        List<Double> every = new ArrayList<>();
        List<Double> rare = new ArrayList<>();
        simulation.addObserver(onMove(motion -> {
            every.add(motion.getEndTime() - motion.getStartTime());
        }));
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
        assertArrayEquals(alone.system().getOwnState(), observed.system().getOwnState());
        assertEquals(alone.system().getEvaluations(), observed.system().getEvaluations());
        assertEquals(201, every.size());
        assertEquals(0.005, every.get(200), 1e-12, "the last step is shortened");
        assertEquals(4, rare.size());
    }

    /** Free fall is a parabola, which the cubic through positions and velocities meets exactly. */
    @Test
    void interpolatedFramesLieOnTheParabola() {
        Simulation simulation = new ShortRun("rk4 clamp 0.25 1",
                "particles: [{id: p, position: [1, 2, 3], velocity: [4, 5, 6]}]").getSimulation();
        simulation.addObserver(onMove(motion -> {
            double[] between = new double[6];
            for (double t = motion.getStartTime(); t <= motion.getEndTime(); t += 0.0625) {
                motion.interpolate(t, between);
                assertEquals(1 + 4 * t, between[0], 1e-14);
                assertEquals(2 + 5 * t - 9.81 * t * t / 2, between[1], 1e-14);
                assertEquals(5 - 9.81 * t, between[4], 1e-13);
                assertEquals(6, between[5], 1e-13);
            }
        }));
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
        Simulation simulation = new ShortRun("euler clamp 1 100", """
                particles: [{id: a, position: [0, 0, 0], fixed: true}, {id: b, position: [1.1, 0, 0]}]
                springs: [{from: a, to: b, stiffness: 9, restLength: 0}]
                effects: []
                """).getSimulation();
        simulation.addRule(new EnergyLimit(1e5));
        SimulationException e = assertThrows(SimulationException.class, simulation::run);
        assertEquals(1, e.getParticle());
        assertTrue(e.getMessage()
                .matches("the kinetic energy is [\\d.e]+ J, above the limit of 100000 J"), e.getMessage());
        assertTrue(simulation.getSteps() >= 5 && simulation.getSteps() <= 8, "steps: " + simulation.getSteps());
    }

    @Test
    void aNumberThatIsNotFiniteEndsTheRunWithItsParticle() {
        ParticleSystem system = Systems.row(2);
        system.getOwnState()[10] = 1e308;
        SimulationException e = Steps.assertFails(SimulationException.class, "EulerSolver at t = 0.0",
                () -> run(system, new EulerSolver(), 10, 100));
        assertEquals(1, e.getParticle());
    }

    /** The clock is a multiple of deltaT, which a sum of 100,000 tenths is not: it is off by 2e-8. */
    @ParameterizedTest
    @CsvSource(textBlock = """
            0.1,   10000, 100000
            0.1,   1,     10
            0.01,  1,     100
            0.3,   1,     4
            1,     0.25,  1
            0.001, 10,    10000
            0.1,   0,     0
            0.001, 500,   500000
            0.1,   0.3,   3
            0.7,   2.1,   3
            0.07,  0.7,   10
            0.003, 0.3,   100
            1e-5,  1,     100000
            0.06,  0.6,   10
            0.3,   2.71,  10
            0.1,   1.05,  11
            0.01,  0.01,  1
            1e8,   12.6,  1
            """)
    void stepsAreCountedAndTheRunEndsAtItsDuration(double deltaT, double duration, long steps) {
        ParticleSystem system = oneParticle(Vector3.ZERO, new Vector3(1, 0, 0));
        Simulation simulation = new Simulation(system, EulerSolver::new, deltaT, duration);
        long[] made = {0};
        simulation.addObserver(onMove(motion -> {
            made[0]++;
            assertEquals(made[0] < steps ? made[0] * deltaT : duration, motion.getEndTime());
        }));
        simulation.run();
        assertEquals(steps, simulation.getSteps());
        assertEquals(steps, made[0]);
        assertEquals(duration, system.getTime());
        assertEquals(duration, system.getOwnState()[0], 1e-11 * duration);
    }

    /** Solvers with a memory go on with it, although the clock is set after each step. */
    @ParameterizedTest
    @CsvSource({"adams, 2006", "verlet, 1001"})
    void aClockSetToAMultipleKeepsASolversMemory(String solver, long evaluations) {
        Scene scene = SceneBuilder.build(TestScenes.named("02-one-spring").withSolver(solver).withDeltaT(0.01)
                .withDuration(10));
        scene.simulation().run();
        assertEquals(evaluations, scene.system().getEvaluations());
    }

    /** Contacts may contradict each other at the very beginning; energy charts and files then have one state. */
    @Test
    void observersHaveTheBeginningOfARunThatFailsThere() {
        ParticleSystem system = oneParticle(Vector3.ZERO, new Vector3(2, 0, 0));
        Simulation simulation = new Simulation(system, EulerSolver::new, 0.1, 1);
        simulation.addRule(new Rule() {
            @Override
            public String getName() {
                return "contradiction";
            }

            @Override
            public void start(ParticleSystem s) {
                throw new SimulationException(0, -1, "no solution", null);
            }

            @Override
            public boolean afterStep(ParticleSystem s, double deltaT) {
                return false;
            }
        });
        EnergyHistory energy = new EnergyHistory();
        simulation.addObserver(energy);
        assertThrows(SimulationException.class, simulation::run);
        assertFalse(energy.hasGrown());
        assertArrayEquals(new double[] {2}, energy.chart().series().get(0).y());
    }

    @Test
    void invalidParticlesAndRunsAreRefused() {
        ParticleSystem system = new ParticleSystem();
        Vector3 nowhere = new Vector3(Double.NaN, 0, 0);
        List<Executable> bad = new ArrayList<>(List.of(
                () -> system.addParticle("p", 1, nowhere, Vector3.ZERO, false),
                () -> system.addParticle("p", 1, Vector3.ZERO, nowhere, false),
                () -> system.addParticle("p", 1, Vector3.ZERO, new Vector3(1, 0, 0), true),
                () -> new Simulation(system, EulerSolver::new, 1, -1), () -> new EnergyLimit(Double.NaN)));
        for (double number : new double[] {0, -1, Double.NaN, Double.POSITIVE_INFINITY}) {
            bad.add(() -> system.addParticle("p", number, Vector3.ZERO, Vector3.ZERO, false));
            bad.add(() -> new Simulation(system, EulerSolver::new, number, 1));
        }
        bad.add(() -> system.addParticle("p", 1e-320, Vector3.ZERO, Vector3.ZERO, false));
        Steps.assertRefused(bad.toArray(Executable[]::new));
        assertEquals(0, system.getStateSize());
    }

    @Test
    void theStateIsInterleavedAndTheDerivativeIsVelocityAndForceOverMass() {
        ParticleSystem system = new ParticleSystem();
        system.addParticle("a", 2, new Vector3(1, 2, 3), new Vector3(4, 5, 6), false);
        system.addParticle("b", 2, new Vector3(7, 8, 9), Vector3.ZERO, true);
        addGravity(system);
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
