package deSolvers.implicit;

import static deSolvers.problems.Bounds.assertAbove;
import static deSolvers.problems.Bounds.assertBelow;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.DESolver;
import deSolvers.adaptive.AdaptiveContract;
import deSolvers.problems.Chain;
import deSolvers.problems.Law;
import deSolvers.problems.Steps;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class RadauIIASolverTest extends AdaptiveContract {
    /** The estimate of order 3 makes h fall with tolerance^(1/4), the error of order 5 with h^5. */
    RadauIIASolverTest() {
        super(RadauIIASolver::new, RadauIIASolver::new, 1.25);
    }

    @Override
    protected boolean isExplicit() {
        return false;
    }

    @Test
    void aFullMatrixOfTwoHundredUnknownsMeetsTheTolerance() {
        Chain chain = new Chain(100, 20);
        RadauIIASolver solver = new RadauIIASolver(1e-6, 1e-6);
        solver.stepState(chain, 30);
        assertBelow(2e-7, chain.error());         // measured 5.8e-8
    }

    /**
     * x'' = 1 - x from rest, all zeros: one tolerance may be 0. Without an absolute one the first sub-step, which
     * leaves 0, is the shorter for it.
     */
    @ParameterizedTest
    @CsvSource({"1e-6, 0, 281, 1.2e-9", "0, 1e-6, 164, 2.0e-9", "1e-6, 1e-9, 255, 1e-9", "0, 1e-9, 843, 4e-13"})
    void oneToleranceMayBeZeroAndTheStateToo(double relative, double absolute, int evaluations, double error) {
        Law pulled = new Law((t, s, dSdt) -> {
            dSdt[0] = s[1];
            dSdt[1] = 1 - s[0];
        }, t -> new double[] {1 - StrictMath.cos(t), StrictMath.sin(t)});
        DESolver solver = new RadauIIASolver(relative, absolute);
        Steps.make(4, solver, pulled, 0.5);
        // Both columns as measured. When sizes were those of the beginning alone, the first failed and the second took
        // 6980.
        assertTrue(pulled.getEvaluations() <= 1.1 * evaluations, pulled.getEvaluations() + " evaluations");
        assertBelow(2 * error, pulled.error());
        assertAbove(error / 2, pulled.error(), "or another bound would do");
    }
}
