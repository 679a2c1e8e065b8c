package deSolvers.hard;

import static org.junit.jupiter.api.Assertions.assertEquals;

import deSolvers.DESolver;
import deSolvers.catalog.SolverCatalog;
import deSolvers.problems.Oscillator;
import deSolvers.problems.Steps;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * A million steps. Hard, because each solver moves the clock to stages and back, and a rounding a step would be a
 * second's error after 1e15 of them, or a time at which the derivative is never asked again.
 */
@Tag("hard")
class MillionStepsTest {
    private static final int STEPS = 1_000_000;

    private static double timeAfter(DESolver solver, double deltaT) {
        Oscillator still = new Oscillator(1, 0, 0);
        Steps.make(STEPS, solver, still, deltaT);
        assertEquals(0, still.getState()[0], "at rest");
        return still.getTime();
    }

    /** A dyadic deltaT is exact for ever. */
    @ParameterizedTest
    @MethodSource("deSolvers.catalog.SolverCatalog#names")
    void theClockIsExactForADyadicStep(String solver) {
        assertEquals(15625.0, timeAfter(SolverCatalog.create(solver), 1.0 / 64));
    }

    /**
     * 0.1 is not dyadic: the clock is bit for bit the floating-point sum of a million 0.1, which is 1.3e-6 too large.
     */
    @ParameterizedTest
    @MethodSource("deSolvers.catalog.SolverCatalog#names")
    void theClockIsTheRoundedSumForAnyOtherStep(String solver) {
        double sum = 0;
        for (int i = 0; i < STEPS; i++) {
            sum += 0.1;
        }
        assertEquals(100000.00000133288, sum);
        assertEquals(sum, timeAfter(SolverCatalog.create(solver), 0.1));
    }
}
