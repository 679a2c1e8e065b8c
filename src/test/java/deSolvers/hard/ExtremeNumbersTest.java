package deSolvers.hard;

import static org.junit.jupiter.api.Assertions.assertEquals;

import deSolvers.DESolver;
import deSolvers.catalog.SolverCatalog;
import deSolvers.problems.Oscillator;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * x'' = -x in units that make x 1e-300, denormal, 1e150 or 1e300. Hard, because squares of such numbers are 0 or
 * infinite: a norm that squares, a tolerance that is added, a quotient of differences can all go wrong where the motion
 * is the same.
 */
@Tag("hard")
class ExtremeNumbersTest {
    private static final double H = 1.0 / 16;

    private static double[] end(String solver, double scale) {
        Oscillator problem = new Oscillator(1, scale, 0);
        HardRun.of(solver, problem, H, 32).assertFollows(Double.POSITIVE_INFINITY);
        return problem.getState();
    }

    /** The largest deviation from a run with numbers of about 1, relative to the scale. */
    private static double difference(String solver, double scale) {
        double[] unit = end(solver, 1);
        double[] scaled = end(solver, scale);
        return Math.max(Math.abs(scaled[0] / scale - unit[0]), Math.abs(scaled[1] / scale - unit[1]));
    }

    /**
     * Fixed-step solvers make the same motion up to round-off: measured 1.1e-15, and 5e-14 for denormal numbers (1e-310
     * has 13 digits left). Adaptive ones may differ by their tolerance, since the absolute tolerance matters more or
     * less; measured 1.3e-7.
     */
    @ParameterizedTest
    @MethodSource("deSolvers.catalog.SolverCatalog#names")
    void theMotionIsTheSameInAnyUnits(String solver) {
        boolean adaptive = SolverCatalog.info(solver).adaptive();
        for (double scale : new double[] {1e-300, 1e150, 1e300}) {
            assertEquals(0, difference(solver, scale), adaptive ? 5e-7 : 5e-15, "scale " + scale);
        }
        assertEquals(0, difference(solver, 1e-310), adaptive ? 5e-7 : 2e-12, "denormal");
    }

    /** A state of 0 stays 0. */
    @ParameterizedTest
    @MethodSource("deSolvers.catalog.SolverCatalog#names")
    void aStateOfZeroStaysZero(String solver) {
        double[] end = end(solver, 0);
        assertEquals(0, end[0]);
        assertEquals(0, end[1]);
    }

    /** A step of 1e-300 s moves the clock from 0 and, with a speed of 1e300, the particle. */
    @ParameterizedTest
    @MethodSource("deSolvers.catalog.SolverCatalog#names")
    void aTinyStepWithAHugeSpeedMovesTheParticle(String solver) {
        Oscillator problem = new Oscillator(1, 0, 1e300);
        DESolver made = SolverCatalog.create(solver);
        made.stepState(problem, 1e-300);
        assertEquals(1e-300, problem.getTime());
        assertEquals(1, problem.getState()[0], 1e-9);
        assertEquals(1e300, problem.getState()[1], 1e285);
    }

    /** Overflow within a step is a clear failure, not a state of infinities. */
    @ParameterizedTest
    @MethodSource("deSolvers.catalog.SolverCatalog#names")
    void overflowIsReported(String solver) {
        HardRun.of(solver, new Oscillator(1e10, 1e300, 0), H, 1).assertFails("");
    }
}
