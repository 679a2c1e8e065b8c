package deSolvers.adaptive;

import deSolvers.DESolver;

class StepDoublingSolverTest extends AdaptiveContract {
    @Override
    protected DESolver createSolver() {
        return new StepDoublingSolver();
    }

    @Override
    protected DESolver createSolver(double relativeTolerance, double absoluteTolerance) {
        return new StepDoublingSolver(relativeTolerance, absoluteTolerance);
    }

    @Override
    protected double toleranceExponent() {
        return 0.8;
    }
}
