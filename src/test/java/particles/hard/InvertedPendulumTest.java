package particles.hard;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static particles.Systems.springs;
import static particles.hard.HardSystems.add;
import static particles.hard.HardSystems.simulation;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import particles.ParticleSystem;
import particles.effects.Gravity;
import particles.law.Vector3;

/**
 * A bob stands on a spring, straight above the pivot, where spring and weight cancel exactly. Hard, because every
 * rounding sideways grows by e in 0.35 s: in ten seconds 1e-16 is the length of the pendulum.
 */
@Tag("hard")
class InvertedPendulumTest {
    private static final double G = 8;

    private static ParticleSystem standing(double aside) {
        ParticleSystem system = new ParticleSystem();
        add(system, "pivot", 1, 0, 0, true);
        add(system, "bob", 1, aside, 1, false);
        springs(system).addSpring(0, 1, 1024, 1 + G / 1024, 0);
        system.addEffect(new Gravity(system.getParticles(), new Vector3(0, -G, 0)));
        return system;
    }

    /** A minute is 170 e-folds: without any round-off the balance is kept bit for bit. */
    @ParameterizedTest
    @MethodSource("deSolvers.catalog.SolverCatalog#names")
    void theExactBalanceIsKeptForEver(String solver) {
        ParticleSystem system = standing(0);
        simulation(system, solver, 1.0 / 128, 60, 1e9).run();
        double[] s = system.getOwnState();
        for (int k = 6; k < 12; k++) {
            assertEquals(k == 7 ? 1.0 : 0.0, s[k], "entry " + k);
        }
    }

    /** A billionth aside, it falls as cosh(t sqrt(g/l)), in 6 s to 1.0922 cm, less 2.2e-5 for sin x < x. Measured. */
    @ParameterizedTest
    @CsvSource(textBlock = """
            rk4,               4e-5
            step-doubling,     4e-5
            dormand-prince,    4e-5
            bulirsch-stoer,    4e-5
            adams,             4e-5
            yoshida4,          4e-5
            radau,             4e-5
            verlet,            1e-3
            midpoint,          3e-3
            implicit-midpoint, 2e-3
            symplectic-euler,  0.03
            euler,             0.2
            backward-euler,    0.25
            """)
    void aSmallDisplacementGrowsExponentially(String solver, double relative) {
        ParticleSystem system = standing(0x1p-30);
        simulation(system, solver, 1.0 / 128, 6, 1e9).run();
        double grown = 0x1p-30 * StrictMath.cosh(6 * Math.sqrt(G));
        assertEquals(grown, system.getOwnState()[6], relative * grown);
    }
}
