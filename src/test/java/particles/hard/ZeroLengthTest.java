package particles.hard;

import static deSolvers.problems.Bounds.assertAbove;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static particles.Systems.springs;
import static particles.hard.HardSystems.simulation;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import particles.ParticleSystem;
import particles.law.Vector3;

/**
 * Two particles pass through each other against a spring of rest length 1. Hard, because the force keeps its size down
 * to length 0 and reverses there: no method has an order across such a jump, and at length 0 the force has no
 * direction.
 */
@Tag("hard")
class ZeroLengthTest {

    private static ParticleSystem pair(double x, double speed) {
        ParticleSystem system = new ParticleSystem();
        system.addParticle("a", 1, new Vector3(-x, 0, 0), new Vector3(speed, 0, 0), false);
        system.addParticle("b", 1, new Vector3(x, 0, 0), new Vector3(-speed, 0, 0), false);
        springs(system).addSpring(0, 1, 10, 1, 0);
        return system;
    }

    /** 10 s, about 14 passages. Coordinates off the line stay exactly 0. The energies were measured. */
    @ParameterizedTest
    @CsvSource(textBlock = """
            euler,             3.484
            midpoint,          1.0054
            rk4,               0.9764
            step-doubling,     1
            dormand-prince,    1.0004
            bulirsch-stoer,    0.9992
            adams,             1.0125
            symplectic-euler,  1.038
            verlet,            1.0251
            yoshida4,          1.0413
            backward-euler,    0.3026
            implicit-midpoint, 1.0005
            radau,             1
            """)
    void particlesPassThroughZeroLength(String solver, double energy) {
        ParticleSystem system = pair(0.5, 4);
        double start = system.getEnergy(system.getOwnState(), 0);
        simulation(system, solver, 1.0 / 128, 10, 1e3 * start).run();
        double[] s = system.getOwnState();
        assertEquals(energy, system.getEnergy(s, 10) / start, 2e-3);
        assertEquals(0, s[1]);
        assertEquals(0, s[8]);
        assertEquals(-s[0], s[6], 1e-12, "symmetric");
    }

    /** With 4 J against 5 J of compression they cannot pass; the particles turn back at length 0.106. */
    @ParameterizedTest
    @MethodSource("deSolvers.catalog.SolverCatalog#names")
    void particlesTurnBackBeforeZeroLength(String solver) {
        ParticleSystem system = pair(0.5, 2);
        simulation(system, solver, 1.0 / 512, 1, 1e3).run();
        assertAbove(0, system.getOwnState()[6], "never through");
    }

    /** At length 0 the spring has no direction: the unstable equilibrium is kept exactly, without a division by 0. */
    @ParameterizedTest
    @MethodSource("deSolvers.catalog.SolverCatalog#names")
    void atRestAtZeroLengthNothingMoves(String solver) {
        ParticleSystem system = pair(0, 0);
        simulation(system, solver, 1.0 / 64, 5, 1e3).run();
        for (int k = 0; k < system.getStateSize(); k++) {
            assertEquals(0, Math.abs(system.getOwnState()[k]));
        }
    }
}
