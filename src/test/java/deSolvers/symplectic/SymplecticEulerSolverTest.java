package deSolvers.symplectic;

import deSolvers.DESolver;

class SymplecticEulerSolverTest extends SymplecticContract {
    @Override
    protected DESolver createSolver() {
        return new SymplecticEulerSolver();
    }

    @Override
    protected int order() {
        return 1;
    }

    @Override
    protected double[] oscillatorStep(double h) {
        return new double[] {1 - h * h, h, -h, 1};      // v' = v - h x, then x' = x + h v'
    }

    @Override
    protected double energyBound(double h) {
        return h / (2 - h);
    }

    @Override
    protected boolean isReversible() {
        return false;
    }
}
