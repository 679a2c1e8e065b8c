package particles.hard;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Systems.springs;
import static particles.hard.HardSystems.add;
import static particles.hard.HardSystems.assertFailsBefore;
import static particles.hard.HardSystems.simulation;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import particles.ParticleSystem;
import particles.effects.Gravity;
import particles.effects.springs.SpringForce;
import particles.law.Vector3;

/**
 * 50 links of 10 g, each on a spring of 1e4 N/m, carry 10 kg. Hard, because the links could vibrate at 2,000 rad/s,
 * while the load bobs at 4.4: a stiff system that looks like a pendulum clock, and whose force has to come through 50
 * springs.
 */
@Tag("hard")
class LoadedChainTest {
    private static final int LINKS = 50;
    private static final double STIFFNESS = 1e4;
    private static final double LINK = 0.01;
    private static final double LOAD = 10;
    private static final double G = 10;
    private static final double FRAME = 1.0 / 30;

    private static ParticleSystem chain(double damping) {
        ParticleSystem system = new ParticleSystem();
        add(system, "hook", 1, 0, 0, true);
        SpringForce springs = springs(system);
        for (int i = 1; i <= LINKS; i++) {
            add(system, "link" + i, i == LINKS ? LOAD : LINK, 0, -0.1 * i, false);
            springs.addSpring(i - 1, i, STIFFNESS, 0.1, damping);
        }
        system.addEffect(new Gravity(system.getParticles(), new Vector3(0, -G, 0)));
        return system;
    }

    private static double load(ParticleSystem system) {
        return system.getOwnState()[6 * LINKS + 1];
    }

    /** The equilibrium of the load: every spring carries the weight below it. */
    private static double balance() {
        double y = 0;
        for (int i = 1; i <= LINKS; i++) {
            y -= 0.1 + ((LINKS - i) * LINK + LOAD) * G / STIFFNESS;
        }
        return y;
    }

    @ParameterizedTest
    @ValueSource(strings = {"euler", "midpoint", "rk4", "adams", "symplectic-euler", "verlet", "yoshida4"})
    void explicitStepsOfAFrameExplode(String solver) {
        assertFailsBefore(0.2, "", simulation(chain(0), solver, FRAME, 20, 1e5));
    }

    /** Measured 7.0e-4 m from the balance of -5.51225 m after 20 s, and 3.4e-4 m/s. */
    @Test
    void backwardEulerReachesEquilibriumInStepsOfAFrame() {
        ParticleSystem system = chain(5);
        simulation(system, "backward-euler", FRAME, 20, 1e5).run();
        assertEquals(balance(), load(system), 2e-3);
        assertTrue(HardSystems.fastest(system) < 1e-3);
    }

    /**
     * The load oscillates about its equilibrium with its initial stretching as amplitude: measured -5.65194 m after 1 s
     * by four methods. Below 2/omega_max, 1 ms, the explicit ones do as well: 4e-4 s are 0.8.
     */
    @ParameterizedTest
    @CsvSource(textBlock = """
            step-doubling,     512,  1e-5
            dormand-prince,    512,  1e-5
            bulirsch-stoer,    512,  1e-5
            implicit-midpoint, 512,  5e-5
            backward-euler,    512,  5e-3
            rk4,               2500, 1e-5
            verlet,            2500, 1e-5
            yoshida4,          2500, 1e-5
            symplectic-euler,  2500, 1e-3
            """)
    void theLoadOscillatesAboutItsEquilibrium(String solver, double stepsASecond, double bound) {
        ParticleSystem system = chain(0);
        simulation(system, solver, 1 / stepsASecond, 1, 1e5).run();
        assertEquals(-5.651920, load(system), bound);
    }
}
