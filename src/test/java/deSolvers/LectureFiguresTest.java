package deSolvers;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.catalog.SolverCatalog;
import deSolvers.problems.Oscillator;
import deSolvers.problems.Steps;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What the lecture says of its figures, x'' = -x from (1, 0): Euler's growth, and the cost of RK4 and midpoint. */
class LectureFiguresTest {
    private static Oscillator run(String solver, double deltaT, int steps) {
        Oscillator oscillator = new Oscillator();
        Steps.make(steps, SolverCatalog.create(solver), oscillator, deltaT);
        return oscillator;
    }

    /** The energy by that at the start, x = 1 and v = 0. */
    private static double energyFactor(Oscillator end) {
        double[] s = end.getState();
        return s[1] * s[1] + s[0] * s[0];
    }

    /** 160.6 steps of 0.11737 are three oscillations. */
    @Test
    void afterThreeOscillationsEulerHasNineTimesTheEnergy() {
        assertTrue(energyFactor(run("euler", 0.11737, 161)) > 9);
        assertTrue(energyFactor(run("euler", 0.11737, 160)) < 9);
    }

    @ParameterizedTest
    @CsvSource({"10, 5.279", "20, 2.563", "50, 1.479", "100, 1.218"})
    void eulersAmplitudeGrowsWithinAPeriod(int steps, double amplitude) {
        assertEquals(amplitude, Math.sqrt(energyFactor(run("euler", 2 * Math.PI / steps, steps))), 0.0005);
    }

    /** The exercise "estimate the cost of RK4 versus midpoint for similar accuracy"; T = 100. */
    @ParameterizedTest
    @CsvSource({"1e-1, 2608, 680", "1e-2, 8166, 1208", "1e-3, 25848, 2152", "1e-4, 82178, 3860", "1e-6, 819326, 12180"})
    void rk4NeedsFewerEvaluationsForEqualError(double error, int midpointEvaluations, int rk4Evaluations) {
        // The counts are given to 1 %, hence the errors to 2 % and 4 %.
        assertEquals(1, finalError("midpoint", midpointEvaluations / 2) / error, 0.02);
        assertEquals(1, finalError("rk4", rk4Evaluations / 4) / error, 0.04);
    }

    private static double finalError(String solver, int steps) {
        Oscillator end = run(solver, 100.0 / steps, steps);
        double x = end.getState()[0] - StrictMath.cos(100);
        double v = end.getState()[1] + StrictMath.sin(100);
        return Math.hypot(x, v);
    }
}
