package deSolvers;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.catalog.SolverCatalog;
import deSolvers.problems.Oscillator;
import deSolvers.problems.Steps;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The numbers behind the lecture's figures, x'' = -x from (1, 0): amplitude |R(ih)|^N, phase N arg R(ih). */
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

    /** Bounds are half a unit of the last digit printed. */
    @ParameterizedTest
    @CsvSource({
        "midpoint, 1,   11,   3.411969, 11.641532, 1.178636,  22",
        "midpoint, 0.5, 100,  2.171047, 4.713443,  1.914611,  200",
        "midpoint, 0.1, 5000, 1.064494, 1.133147,  0.830824,  10000",
        "rk4,      1,   8,    0.952268, 0.906814,  -0.044631, 32",
        "rk4,      1,   100,  0.542612, 0.294427,  -0.557889, 400",
        "rk4,      0.4, 1250, 0.965755, 0.932682,  -0.100637, 5000"})
    void figuresMatchTheLecture(String solver, double deltaT, int steps, double amplitude, double energy,
    double phase,
                                     int evaluations) {
        Oscillator end = run(solver, deltaT, steps);
        assertEquals(amplitude, Math.sqrt(energyFactor(end)), 0.5e-6);
        assertEquals(energy, energyFactor(end), 0.5e-6);
        // The state turns clockwise, x + iv = e^{-it}; a positive error is a method that lags.
        double angle = -StrictMath.atan2(end.getState()[1], end.getState()[0]);
        double error = StrictMath.IEEEremainder(deltaT * steps - angle, 2 * Math.PI);
        assertEquals(phase, Math.abs(error) * Math.signum(phase), 0.5e-6);
        assertEquals(Math.signum(phaseOfOneStep(solver, deltaT) - deltaT), Math.signum(phase), "sign");
        assertEquals(evaluations, end.getEvaluations());
    }

    private static double phaseOfOneStep(String solver, double deltaT) {
        double[] s = run(solver, deltaT, 1).getState();
        return -StrictMath.atan2(s[1], s[0]);
    }

    @Test
    void afterThreeOscillationsEulerHasNineTimesTheEnergy() {
        assertEquals(9.050, energyFactor(run("euler", 0.11737, 161)), 0.0005);
        assertTrue(energyFactor(run("euler", 0.11737, 160)) < 9);
        // 160.6 steps of 0.11737 are 3 oscillations
        assertEquals(3, 160.6 * 0.11737 / (2 * Math.PI), 0.0005);
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
        return Math.sqrt(x * x + v * v);
    }
}
