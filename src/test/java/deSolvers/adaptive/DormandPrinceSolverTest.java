package deSolvers.adaptive;

import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.DESolver;
import org.junit.jupiter.api.Test;

class DormandPrinceSolverTest extends AdaptiveContract {
    @Override
    protected DESolver createSolver() {
        return new DormandPrinceSolver();
    }

    @Override
    protected DESolver createSolver(double relativeTolerance, double absoluteTolerance) {
        return new DormandPrinceSolver(relativeTolerance, absoluteTolerance);
    }

    @Override
    protected double toleranceExponent() {
        return 1;
    }

    /** With loose tolerances: measured 23 at 0.01 and 3.3e22 at 0.1, with every sub-step within its tolerance. */
    @Test
    void aLooseToleranceLetsAVibrationGrow() {
        assertTrue(fastAmplitude(0.01) > 10 && fastAmplitude(0.1) > 1e22, "left " + fastAmplitude(0.1));
    }
}
