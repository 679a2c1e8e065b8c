package deSolvers.adaptive;

import deSolvers.DESolver;

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
}
