package particles.energy;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Systems.addGravity;
import static particles.Systems.springs;

import deSolvers.catalog.SolverCatalog;
import deSolvers.catalog.SolverInfo;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import particles.ParticleSystem;
import particles.Simulation;
import particles.Systems;
import particles.effects.springs.SpringForce;
import particles.law.Vector3;

/** Steps per period, in closed form: a vibration whose phase advances by theta per step has 2 pi / theta. */
class ResolutionTest {
    private static final double SCALE = 1e-6;

    /** Weights of 1 kg on springs of length 1 m from a hook, each pulled down by its amplitude. */
    private static ParticleSystem weights(double[] omega, double[] amplitude, double speed) {
        ParticleSystem system = new ParticleSystem();
        SpringForce springs = springs(system);
        system.addParticle("hook", 1, Vector3.ZERO, Vector3.ZERO, true);
        for (int i = 0; i < omega.length; i++) {
            system.addParticle("w" + i, 1, new Vector3(0, -1 - amplitude[i], 0),
                    new Vector3(0, speed, 0), false);
            springs.addSpring(0, i + 1, omega[i] * omega[i], 1, 0);
        }
        return system;
    }

    private static Resolution run(ParticleSystem system, String solver, double deltaT, double steps) {
        Simulation run = new Simulation(system, () -> SolverCatalog.create(solver), deltaT, steps * deltaT);
        Resolution resolution = new Resolution(deltaT, steps * deltaT);
        run.addObserver(resolution);
        run.run();
        return resolution;
    }

    private static Resolution oscillator(String solver, double theta, int steps) {
        return run(weights(new double[] {1}, new double[] {1e-3}, 1e-3), solver, theta, steps);
    }

    private static Stream<String> fixedSteps() {
        return SolverCatalog.all().stream().filter(info -> !info.adaptive()).map(SolverInfo::name);
    }

    /**
     * Verlet turns by 2 asin(theta / 2) per step, faster than the true vibration; implicit midpoint by less, 2
     * atan(theta / 2), where the forces tell. The first sums do not cover whole periods: measured 0.6 % off.
     */
    @ParameterizedTest
    @ValueSource(doubles = {0.5, 0.9, 1.1, 1.4})
    void theShorterOfTheComputedAndTheTruePeriodCounts(double theta) {
        assertEquals(2 * Math.PI / theta, oscillator("implicit-midpoint", theta, 400).stepsPerPeriod(SCALE), 1e-6);
        double turns = Math.PI / Math.asin(theta / 2);
        assertEquals(turns, oscillator("verlet", theta, 400).stepsPerPeriod(SCALE), 0.02 * turns);
    }

    /** Whatever a solver makes of five steps: euler lets them grow, yoshida4 turns them into eight. */
    @ParameterizedTest
    @MethodSource("fixedSteps")
    void sevenStepsPerPeriodAreResolvedAndFiveAreNot(String solver) {
        assertFalse(oscillator(solver, 2 * Math.PI / 7, 20).isTooCoarse(SCALE), solver);
        assertTrue(oscillator(solver, 2 * Math.PI / 5, 12).isTooCoarse(SCALE), solver);
    }

    /** One or two steps have no second differences: the force tells omega, 2 pi / theta exactly, with any solver. */
    @ParameterizedTest
    @MethodSource("fixedSteps")
    void oneStepIsJudgedByItsForces(String solver) {
        for (int steps : new int[] {1, 2}) {
            assertEquals(2 * Math.PI / 1.4, oscillator(solver, 1.4, steps).stepsPerPeriod(SCALE), 1e-9, solver);
            assertEquals(2 * Math.PI / 0.7, oscillator(solver, 0.7, steps).stepsPerPeriod(SCALE), 1e-9, solver);
        }
    }

    /** Nothing vibrates in a fall, whether of one step or many. */
    @Test
    void aFallIsResolved() {
        for (int steps : List.of(1, 2, 50)) {
            ParticleSystem system = Systems.row(1);
            addGravity(system);
            assertFalse(run(system, "rk4", 0.5, steps).isTooCoarse(SCALE), steps + " steps");
        }
    }

    /**
     * Beside a slow swing of 1 J, a vibration with theta = 2.5 has S1 / S0 = q e / (1 + e) with q = 2.4 and its share e
     * of the energy of motion as computed. Of 0.2 J it is visible; of 0.002 J it is not.
     */
    @Test
    void aVibrationThatCarriesLittleEnergyIsNotVisible() {
        double fast = 25;
        for (double energy : new double[] {0.2, 0.002}) {
            ParticleSystem system = weights(new double[] {1, fast}, new double[] {Math.sqrt(2),
                    Math.sqrt(2 * energy) / fast}, 0);
            assertEquals(energy > 0.1, run(system, "implicit-midpoint", 0.1, 400).isTooCoarse(1), energy + " J");
        }
    }

    /** A stiff spring that nothing excites does not count, however stiff. */
    @Test
    void anUnexcitedStiffSpringDoesNotCount() {
        ParticleSystem system = weights(new double[] {1, 1e4}, new double[] {0.5, 0}, 0);
        assertFalse(run(system, "implicit-midpoint", 0.1, 100).isTooCoarse(SCALE));
        assertTrue(Double.isInfinite(run(weights(new double[] {1e4}, new double[] {0}, 0), "implicit-midpoint",
                0.1, 9).stepsPerPeriod(SCALE)));
    }
}
