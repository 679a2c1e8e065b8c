package particles.hard;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.hard.HardSystems.run;
import static particles.hard.HardSystems.springs;

import deSolvers.catalog.SolverCatalog;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import particles.ParticleSystem;
import particles.law.Vector3;

/**
 * Two particles run through each other against a spring of rest length 1. Hard, because the force has its full size up
 * to length 0 and turns round there: it jumps, no method has an order across the jump, and exactly at 0 there is no
 * direction.
 */
@Tag("hard")
class ZeroLengthTest {

    static List<String> solvers() {
        return SolverCatalog.names();
    }

    private static ParticleSystem pair(double x, double speed) {
        ParticleSystem system = new ParticleSystem();
        system.addParticle("a", 1, new Vector3(-x, 0, 0), new Vector3(speed, 0, 0), false);
        system.addParticle("b", 1, new Vector3(x, 0, 0), new Vector3(-speed, 0, 0), false);
        springs(system).addSpring(0, 1, 10, 1, 0);
        return system;
    }

    /** 10 s, about 14 passages. What is off the line stays exactly 0. The energies were measured. */
    @ParameterizedTest
    @CsvSource({"euler, 3.484", "midpoint, 1.0054", "rk4, 0.9764", "step-doubling, 1", "dormand-prince, 1.0004",
        "bulirsch-stoer, 0.9992", "adams, 1.0125", "symplectic-euler, 1.038", "verlet, 1.0251", "yoshida4, 1.0413",
        "backward-euler, 0.3026", "implicit-midpoint, 1.0005", "radau, 1"})
    void throughZeroLengthAndOut(String solver, double energy) {
        ParticleSystem system = pair(0.5, 4);
        double start = system.getEnergy(system.getOwnState(), 0);
        assertFalse(run(system, solver, 1.0 / 128, 10, 1e3 * start).failed());
        double[] s = system.getOwnState();
        assertEquals(energy, system.getEnergy(s, 10) / start, 2e-3);
        assertEquals(0, s[1]);
        assertEquals(0, s[8]);
        assertEquals(-s[0], s[6], 1e-12, "symmetric");
    }

    /**
     * The energy is not enough to get through: 5 J of compression against 4 J; the particles turn back at length 0.106.
     */
    @ParameterizedTest
    @MethodSource("solvers")
    void compressedAlmostToZeroAndBack(String solver) {
        ParticleSystem system = pair(0.5, 2);
        assertFalse(run(system, solver, 1.0 / 512, 1, 1e3).failed());
        assertTrue(system.getOwnState()[6] > 0, "never through: x = " + system.getOwnState()[6]);
    }

    /**
     * At length 0 itself nothing says which way: the unstable balance is kept, exactly, and nothing is divided by 0.
     */
    @ParameterizedTest
    @MethodSource("solvers")
    void atZeroLengthAtRestNothingMoves(String solver) {
        ParticleSystem system = pair(0, 0);
        assertFalse(run(system, solver, 1.0 / 64, 5, 1e3).failed());
        for (int k = 0; k < system.getStateSize(); k++) {
            assertEquals(0, Math.abs(system.getOwnState()[k]));
        }
    }
}
