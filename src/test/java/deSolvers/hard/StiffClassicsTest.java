package deSolvers.hard;

import static deSolvers.problems.Bounds.assertAbove;
import static deSolvers.problems.Bounds.assertBelow;
import static deSolvers.problems.KnownSolutions.END_OF_ROBERTSON;
import static deSolvers.problems.KnownSolutions.END_OF_VAN_DER_POL;
import static deSolvers.problems.KnownSolutions.protheroRobinson;
import static deSolvers.problems.KnownSolutions.robertson;
import static deSolvers.problems.KnownSolutions.stiffPair;
import static deSolvers.problems.KnownSolutions.vanDerPol;
import static org.junit.jupiter.api.Assertions.assertEquals;

import deSolvers.problems.ReferenceProblem;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * The classics of stiffness. Hard, because what decays fast is long gone, and an explicit method has to take its steps
 * for it all the same: if it steps by deltaT it blows up, and if it controls its sub-steps it needs millions of them.
 */
@Tag("hard")
class StiffClassicsTest {

    /** lambda is about -3e6 on the slow stretches, and the jumps between them last 1e-6 s. */
    @ParameterizedTest
    @ValueSource(strings = {"euler", "midpoint", "rk4", "adams"})
    void vanDerPolBlowsUpWithAStepMadeForItsSlowPart(String solver) {
        HardRun run = HardRun.of(solver, vanDerPol(), 1.0 / 1024, 2048).assertFails("Infinity");
        assertAbove(1e200, run.largest(), "it says so only when it overflows");
    }

    /** They need 3e6/3.3 sub-steps a second and more, and give up at 0.97, 0.74 and 1.04 of 2 s. */
    @ParameterizedTest
    @ValueSource(strings = {"step-doubling", "dormand-prince", "bulirsch-stoer"})
    void vanDerPolIsGivenUpByExplicitStepControlWithTheReason(String solver) {
        HardRun.of(solver, vanDerPol(), END_OF_VAN_DER_POL, 1)
                .assertFails("the system is stiff (take an implicit solver)");
    }

    /** In a jump y moves by 3 within a hundredth of the step: Newton's method has no near start, and says so. */
    @ParameterizedTest
    @CsvSource({"backward-euler, 0.8037", "implicit-midpoint, 0.8066"})
    void vanDerPolsJumpIsTooFastForFixedImplicitSteps(String solver, double jump) {
        ReferenceProblem problem = vanDerPol();
        HardRun.of(solver, problem, 1.0 / 1024, 2048).assertFails("Newton's iteration did not converge");
        assertEquals(jump, problem.getTime(), 1e-3, "right up to the jump at 0.807 s");
    }

    /** Measured 3.8e-9 at a tolerance of 1e-6, in 8,886 evaluations. */
    @Test
    void vanDerPolIsFollowedByRadau() {
        ReferenceProblem problem = vanDerPol();
        HardRun.of("radau", problem, END_OF_VAN_DER_POL, 1).assertFollows(2e-8);
        assertBelow(12_000, problem.getEvaluations());
    }

    /** Rates from 0.04 to 3e7; what is stiff is about -2,000 at t = 40. */
    @ParameterizedTest
    @ValueSource(strings = {"euler", "midpoint", "rk4", "adams"})
    void robertsonBlowsUpWithAStepOfASixtyFourth(String solver) {
        assertAbove(1e100, HardRun.of(solver, robertson(), 1.0 / 64, 40 * 64).assertFails("").largest());
    }

    /** Measured error and evaluations: explicit ones do arrive, in 240,000 and more; radau needs 628. */
    @ParameterizedTest
    @CsvSource({"step-doubling, 40, 4.2e-7, 312808", "dormand-prince, 40, 1.6e-9, 242606",
            "bulirsch-stoer, 40, 1.5e-5, 602206",
        "radau, 40, 4.0e-9, 628", "backward-euler, 0.015625, 5.5e-5, 18306",
        "implicit-midpoint, 0.015625, 1.7e-8, 18246"})
    void robertsonIsFollowed(String solver, double deltaT, double error, long evaluations) {
        ReferenceProblem problem = robertson();
        HardRun.of(solver, problem, deltaT, (int) (END_OF_ROBERTSON / deltaT)).assertFollows(3 * error);
        assertBelow(1.5 * evaluations, problem.getEvaluations());
        double[] s = problem.getState();
        assertEquals(1, s[0] + s[1] + s[2], 1e-13, "the sum of the three is kept by every linear-invariant method");
    }

    /** The fast part, -1000, is gone after 1/100 s; 1/64 s is 15 times too long for it and right for the rest. */
    @ParameterizedTest
    @CsvSource({"euler, 1e70", "midpoint, 1e120", "rk4, 1e200", "adams, 1e140"})
    void theStiffPairGrowsInExplicitSteps(String solver, double atLeast) {
        assertAbove(atLeast, HardRun.of(solver, stiffPair(), 1.0 / 64, 64).largest());
        assertBelow(5e-4, HardRun.of(solver, stiffPair(), 1.0 / 1024, 1024).error(), "followed by short ones");
    }

    /** Measured errors; all but the two of low order keep their tolerance of 1e-6. */
    @ParameterizedTest
    @CsvSource({"backward-euler, 5.8e-3", "implicit-midpoint, 1.6e-5", "radau, 1e-13", "step-doubling, 8e-7",
            "dormand-prince, 3e-7",
        "bulirsch-stoer, 9e-8"})
    void theStiffPairIsFollowedInTheSameSteps(String solver, double measured) {
        assertBelow(3, HardRun.of(solver, stiffPair(), 1.0 / 64, 64).assertFollows(3 * measured).largest());
    }

    /** y = cos t for every L; L = -1e7 makes every error in y a slope of 1e7 times that. */
    @ParameterizedTest
    @ValueSource(strings = {"euler", "midpoint", "rk4", "adams"})
    void protheroAndRobinsonsProblemOverflowsInExplicitSteps(String solver) {
        assertAbove(1e290, HardRun.of(solver, protheroRobinson(-1e7), 1.0 / 64, 64).assertFails("").largest());
    }

    /** At least 1e7/5.6 sub-steps a second, where 500,000 are allowed in one call. */
    @ParameterizedTest
    @ValueSource(strings = {"step-doubling", "dormand-prince", "bulirsch-stoer"})
    void protheroAndRobinsonsProblemIsGivenUpByExplicitStepControl(String solver) {
        HardRun.of(solver, protheroRobinson(-1e7), 1, 1).assertFails("the system is stiff (take an implicit solver)");
    }

    /** h/(2L), no damping at all of the error of h^2/16, and the rounding of radau. */
    @ParameterizedTest
    @CsvSource({"backward-euler, 8e-10", "implicit-midpoint, 2e-5", "radau, 2e-14"})
    void protheroAndRobinsonsProblemIsFollowedByImplicitSolvers(String solver, double bound) {
        HardRun.of(solver, protheroRobinson(-1e7), 1.0 / 64, 64).assertFollows(bound);
    }
}
