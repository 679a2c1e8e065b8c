package deSolvers.adaptive;

import deSolvers.DESolver;

/** Step doubling with local extrapolation: of order 5, so that the error follows the tolerance with exponent 1. */
class ExtrapolatedStepDoublingTest extends AdaptiveContract {
    @Override
    protected DESolver createSolver() {
        return createSolver(AdaptiveSolver.RELATIVE_TOLERANCE, AdaptiveSolver.ABSOLUTE_TOLERANCE);
    }

    @Override
    protected DESolver createSolver(double relativeTolerance, double absoluteTolerance) {
        return new StepDoublingSolver(relativeTolerance, absoluteTolerance, true);
    }

    @Override
    protected double toleranceExponent() {
        return 1;
    }

    /** It is not stable on the imaginary axis: measured 493, 362 and 358 times. */
    @Override
    protected double vibrationGrowth() {
        return 1000;
    }
}
