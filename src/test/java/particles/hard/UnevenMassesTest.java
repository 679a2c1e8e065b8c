package particles.hard;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static particles.Systems.springs;
import static particles.hard.HardSystems.add;
import static particles.hard.HardSystems.simulation;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import particles.ParticleSystem;
import particles.Simulation;
import particles.SimulationException;

/**
 * A mass of 1 kg and one of 1,000 t on one spring. Hard, because their accelerations differ by 1e6 under equal forces:
 * what the heavy one moves is lost in the light one's rounding, and a solver that scales all entries alike stops seeing
 * it.
 */
@Tag("hard")
class UnevenMassesTest {
    private static final double HEAVY = 1e6;
    private static final double OMEGA = Math.sqrt(100 * (1 + 1 / HEAVY));

    private static ParticleSystem pair() {
        ParticleSystem system = new ParticleSystem();
        add(system, "heavy", HEAVY, 0, 0, false);
        add(system, "light", 1, 1.5, 0, false);
        springs(system).addSpring(0, 1, 100, 1, 0);
        return system;
    }

    /** Momentum is 0 and the centre of mass stays; measured 5e-14 kg m/s of 5, and 4e-18 m. */
    @ParameterizedTest
    @MethodSource("deSolvers.catalog.SolverCatalog#names")
    void momentumAndCentreOfMassAreConserved(String solver) {
        ParticleSystem system = pair();
        simulation(system, solver, 1.0 / 128, 10, 1e9).run();
        double[] s = system.getOwnState();
        assertEquals(0, HEAVY * s[3] + s[9], solver.equals("euler") ? 1e-11 : 4e-13);
        assertEquals(1.5 / (HEAVY + 1), (HEAVY * s[0] + s[6]) / (HEAVY + 1), 4e-17);
    }

    /** Against 1 + cos(omega t)/2 after 20 s, 32 periods; the errors were measured. Euler's would be 1e3 and more. */
    @ParameterizedTest
    @CsvSource(textBlock = """
            midpoint,          8.7e-2
            rk4,               2.8e-5
            step-doubling,     1.8e-6
            dormand-prince,    3e-8
            bulirsch-stoer,    3e-10
            adams,             1.1e-4
            symplectic-euler,  3.9e-2
            verlet,            2.2e-2
            yoshida4,          2.2e-4
            implicit-midpoint, 4.6e-2
            radau,             2.1e-8
            """)
    void theDistanceOscillatesWithTheReducedMass(String solver, double measured) {
        ParticleSystem system = pair();
        simulation(system, solver, 1.0 / 128, 20, 1e9).run();
        double[] s = system.getOwnState();
        assertEquals(1 + 0.5 * StrictMath.cos(OMEGA * 20), s[6] - s[0], 2 * measured);
    }

    /** Of the two first-order solvers one ends at rest at the rest length, the other has a million times its energy. */
    @ParameterizedTest
    @CsvSource({"backward-euler, 0, 1e-6", "euler, 5e5, 1e7"})
    void firstOrderSolversDampOrGrow(String solver, double atLeast, double atMost) {
        ParticleSystem system = pair();
        double start = system.getEnergy(system.getOwnState(), 0);
        Simulation run = simulation(system, solver, 1.0 / 128, 20, 1e6 * start);
        if (solver.equals("euler")) {
            assertThrows(SimulationException.class, run::run);
        } else {
            run.run();
        }
        double factor = system.getEnergy(system.getOwnState(), system.getTime()) / start;
        assertEquals((atLeast + atMost) / 2, factor, (atMost - atLeast) / 2);
    }
}
