package deSolvers.hard;

import static deSolvers.problems.Bounds.assertAbove;
import static deSolvers.problems.Bounds.assertBelow;
import static org.junit.jupiter.api.Assertions.assertEquals;

import deSolvers.catalog.SolverCatalog;
import deSolvers.problems.Kepler;
import deSolvers.problems.Orbit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * One orbit of eccentricity 0.99. Hard, because at the perihelion, 0.01 from the sun, everything is 1,000 times faster
 * than at the aphelion: a fixed step is wasted on most of the orbit and too long for the rest, and an error made at the
 * perihelion is magnified by 10,000 when the planet comes back to it.
 */
@Tag("hard")
class KeplerAlmostParabolicTest {
    private static final double PERIOD = 2 * Math.PI;

    /** The measured error after one orbit at tolerances of 1e-12, and the measured evaluations. */
    @ParameterizedTest
    @CsvSource({"step-doubling, 1.6e-6, 13276", "dormand-prince, 4.4e-9, 7208", "bulirsch-stoer, 5.8e-10, 3156",
        "radau, 1.1e-10, 67008"})
    void stepControlComesBackToThePerihelion(String solver, double measured, long evaluations) {
        Kepler planet = new Kepler(0.99);
        SolverCatalog.create(solver, 1e-12, 1e-12).stepState(planet, PERIOD);
        double error = Math.sqrt(Orbit.squaredError(planet));
        assertBelow(3 * measured, error);
        assertBelow(1.2 * evaluations, planet.getEvaluations());
    }

    private static HardRun orbit(String solver, Kepler planet, int steps) {
        return HardRun.of(solver, planet, PERIOD / steps, steps);
    }

    /**
     * With 8,192 fixed steps, more than step-size control needs evaluations, every solver ends on another orbit or out
     * of the system.
     */
    @ParameterizedTest
    @ValueSource(strings = {"euler", "midpoint", "rk4", "adams", "symplectic-euler", "verlet", "yoshida4",
            "implicit-midpoint"})
    void fixedStepsOfUsualLengthLoseTheOrbit(String solver) {
        Kepler planet = new Kepler(0.99);
        orbit(solver, planet, 8192).assertFollows(Double.POSITIVE_INFINITY);
        assertAbove(2, Math.abs(Orbit.energy(planet) + 0.5));
    }

    /** 2^19 steps keep it, by their order: the error of the energy -1/2 was measured. */
    @ParameterizedTest
    @CsvSource({"midpoint, 1.7e-3", "symplectic-euler, 3.4e-3", "verlet, 1.8e-3", "implicit-midpoint, 1.8e-3",
            "rk4, 1.6e-9",
        "adams, 1.3e-7", "yoshida4, 8e-12"})
    void halfAMillionFixedStepsKeepTheOrbit(String solver, double measured) {
        Kepler planet = new Kepler(0.99);
        orbit(solver, planet, 1 << 19).assertFollows(Double.POSITIVE_INFINITY);
        assertEquals(-0.5, Orbit.energy(planet), 2 * measured);
    }

    /** First order is not enough even then: the planet escapes. */
    @Test
    void eulerThrowsThePlanetOut() {
        Kepler planet = new Kepler(0.99);
        orbit("euler", planet, 1 << 19);
        assertEquals(0.4992, Orbit.energy(planet), 1e-3, "unbound");
    }

    /**
     * Backward Euler's damping takes energy from the planet: it spirals into the sun, where the equation has no
     * solution.
     */
    @ParameterizedTest
    @CsvSource({"65536, -140", "524288, -660"})
    void backwardEulerFallsIntoTheSun(int steps, double below) {
        Kepler planet = new Kepler(0.99);
        orbit("backward-euler", planet, steps).assertFails("Newton's iteration did not converge");
        assertBelow(below, Orbit.energy(planet));
    }
}
