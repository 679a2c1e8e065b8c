package particles.hard;

import static deSolvers.problems.Bounds.assertBelow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static particles.Systems.springs;
import static particles.hard.HardSystems.add;
import static particles.hard.HardSystems.assertFailsBefore;
import static particles.hard.HardSystems.simulation;

import deSolvers.DESolver;
import deSolvers.catalog.SolverCatalog;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import particles.ParticleSystem;
import particles.Simulation;
import particles.effects.springs.SpringForce;

/**
 * A gram on a spring of 1 to 1e9 N/m, or of 1e6 N s/m. Hard, because the fastest motion decides the step of an explicit
 * method: omega goes up to 1e6 rad/s, 15,000 times too fast for steps of 1/64 s, where nothing of it can be seen.
 */
@Tag("hard")
class StiffSpringsTest {
    private static final double H = 1.0 / 64;
    /** A blow-up, not an oscillation: so many times the energy at the start. */
    private static final double BLOW_UP = 1e6;

    private static ParticleSystem weight(double mass, double stiffness, double damping) {
        ParticleSystem system = new ParticleSystem();
        add(system, "hook", 1, 0, 0, true);
        add(system, "weight", mass, 0, -1.125, false);
        SpringForce springs = springs(system);
        springs.addSpring(0, 1, stiffness, 1, damping);
        return system;
    }

    private static double energy(ParticleSystem system) {
        return system.getEnergy(system.getOwnState(), system.getTime());
    }

    private static Simulation blowUp(ParticleSystem system, String solver) {
        return simulation(system, solver, H, 1, BLOW_UP * energy(system));
    }

    /** omega h is 0.5 at k = 1 and 16 and more from k = 1e3 on, where 2 and 2.83 are the limits. */
    @ParameterizedTest
    @ValueSource(strings = {"euler", "midpoint", "rk4", "adams", "symplectic-euler", "verlet", "yoshida4"})
    void explicitStepsExplodeBeyondTheirLimit(String solver) {
        for (double stiffness : new double[] {1e3, 1e6, 1e9}) {
            assertFailsBefore(0.05, "kinetic energy", blowUp(weight(1e-3, stiffness, 0), solver));
        }
        blowUp(weight(1e-3, 1, 0), solver).run();       // omega h = 0.5
    }

    /**
     * The amplitude falls by (1 + (omega h)^2)^(-1/2) a step, so the weight is at rest after 64; measured 8.5e-7 of the
     * energy at k = 1.
     */
    @ParameterizedTest
    @ValueSource(doubles = {1, 1e3, 1e6, 1e9})
    void backwardEulerDampsFastVibrations(double stiffness) {
        ParticleSystem system = weight(1e-3, stiffness, 0);
        double start = energy(system);
        blowUp(system, "backward-euler").run();
        assertBelow(2e-6, energy(system) / start);
    }

    /**
     * The spring is linear only while it is not turned inside out. From omega h = 16 on, the step's equation has a
     * second solution on the other side of the hook. Newton's method finds that one if it starts from a prediction
     * along the velocity of up to 125 m/s; energy then grew up to 2e5-fold. Starting from the present position it
     * always finds the near one: energy is conserved to round-off, and the spring, 1.125 m long at first, is never
     * shorter than 0.875 m.
     */
    @ParameterizedTest
    @ValueSource(doubles = {1e3, 1e4, 1e6, 1e9})
    void implicitMidpointStaysOnItsSide(double stiffness) {
        ParticleSystem system = weight(1e-3, stiffness, 0);
        double start = energy(system);
        DESolver solver = SolverCatalog.create("implicit-midpoint");
        for (int i = 0; i < 6400; i++) {
            solver.stepState(system, H);
            // Measured 1.6e-12 and 0.8749999 m.
            assertEquals(1, energy(system) / start, 1e-11, "step " + i);
            assertBelow(-0.87499, system.getOwnState()[7]);
        }
    }

    /**
     * They follow every oscillation, at the cost of 160 sub-steps a second at k = 1e3 and 5,000 at 1e6; energy measured
     * within 2.3e-2.
     */
    @ParameterizedTest
    @CsvSource(textBlock = """
            step-doubling,  2e6
            dormand-prince, 1.3e6
            bulirsch-stoer, 8e5
            radau,          2.6e6
            """)
    void adaptiveSolversFollowEveryOscillation(String solver, double evaluations) {
        for (double stiffness : new double[] {1, 1e3, 1e6}) {
            ParticleSystem system = weight(1e-3, stiffness, 0);
            double start = energy(system);
            blowUp(system, solver).run();
            assertEquals(1, energy(system) / start, 0.05, "k = " + stiffness);
            assertBelow(evaluations, system.getEvaluations());
        }
    }

    /** c h/m = 15,625, where explicit methods allow 2 to 2.8. */
    @ParameterizedTest
    @ValueSource(strings = {"euler", "midpoint", "rk4", "adams", "symplectic-euler"})
    void stiffDampingMakesExplicitStepsExplode(String solver) {
        assertFailsBefore(0.05, "kinetic energy", blowUp(weight(1, 100, 1e6), solver));
    }

    /** The fixed-point iteration of their last kick converges only below c h/m = 2; above, the first step fails. */
    @ParameterizedTest
    @ValueSource(strings = {"verlet", "yoshida4"})
    void stiffDampingIsRefusedByLeapfrogs(String solver) {
        assertFailsBefore(H, "as drag or damping, is too stiff for this deltaT",
                blowUp(weight(1, 100, 1e6), solver));
    }

    /** The weight creeps back at the rate k/c = 1e-4 a second: 1.1249875 after 1 s. */
    @ParameterizedTest
    @ValueSource(strings = {"backward-euler", "implicit-midpoint", "radau"})
    void stiffDampingIsFollowedByImplicitSolvers(String solver) {
        ParticleSystem system = weight(1, 100, 1e6);
        blowUp(system, solver).run();
        assertEquals(-1 - 0.125 * StrictMath.exp(-1e-4), system.getOwnState()[7], 2e-9);
    }
}
