package deSolvers.hard;

import static deSolvers.problems.Bounds.assertAbove;
import static deSolvers.problems.Bounds.assertBelow;
import static deSolvers.problems.KnownSolutions.pole;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.problems.ReferenceProblem;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * y' = y^2 from 1 has its pole at t = 1 and no solution after it. Hard, because there is nothing to follow: a solver
 * has to say so, and neither hang nor step over it.
 */
@Tag("hard")
class PoleTest {

    /** The sub-steps shrink to the resolution of the clock at the pole itself, and the source is back at its start. */
    @ParameterizedTest
    @ValueSource(strings = {"step-doubling", "dormand-prince", "bulirsch-stoer", "radau"})
    void stepSizeControlFindsThePole(String solver) {
        ReferenceProblem pole = pole();
        HardRun run = HardRun.of(solver, pole, 2, 1).assertFails("grows without bound");
        String reached = run.message().replaceFirst(".*s after ([0-9.E-]+) s,.*", "$1");
        assertEquals(1, Double.parseDouble(reached), 1e-5, "the pole; measured 2.8e-6 to 6e-9 beyond it");
        assertEquals(0, pole.getTime());
        assertBelow(10_000, pole.getEvaluations(), "it does not hang");
    }

    /** Fixed steps overflow after the pole: 13 steps of 1/64 s late with euler, 2 with rk4. */
    @ParameterizedTest
    @CsvSource({"euler, 1.21", "midpoint, 1.08", "rk4, 1.04", "adams, 1.07"})
    void fixedStepsOverflowSoonAfterIt(String solver, double noLaterThan) {
        ReferenceProblem pole = pole();
        HardRun.of(solver, pole, 1.0 / 64, 128).assertFails("");
        assertTrue(pole.getTime() >= 1 && pole.getTime() <= noLaterThan, "at t = " + pole.getTime());
    }

    /** y + h m^2 = m has no real solution for y > 1/(4h): 16 for steps of 1/64 s, reached before the pole. */
    @ParameterizedTest
    @CsvSource({"backward-euler, 0.92", "implicit-midpoint, 0.98"})
    void implicitStepsEndWhereTheirEquationHasNoSolution(String solver, double noLaterThan) {
        ReferenceProblem pole = pole();
        HardRun.of(solver, pole, 1.0 / 64, 128).assertFails("Newton's iteration did not converge");
        assertTrue(pole.getTime() > 0.85 && pole.getTime() <= noLaterThan, "at t = " + pole.getTime());
        assertAbove(16, pole.getState()[0]);
    }
}
