package deSolvers.extrapolation;

import deSolvers.DESolver;
import deSolvers.adaptive.AdaptiveContract;

class BulirschStoerSolverTest extends AdaptiveContract {
    @Override
    protected DESolver createSolver() {
        return new BulirschStoerSolver();
    }

    @Override
    protected DESolver createSolver(double relativeTolerance, double absoluteTolerance) {
        return new BulirschStoerSolver(relativeTolerance, absoluteTolerance);
    }

    @Override
    protected double toleranceExponent() {
        return 1;
    }
}
