package deSolvers.symplectic;

class SymplecticEulerSolverTest extends SymplecticContract {
    /** v' = v - h x, then x' = x + h v'. */
    SymplecticEulerSolverTest() {
        super(SymplecticEulerSolver::new, 1, h -> new double[] {1 - h * h, h, -h, 1});
    }

    @Override
    double energyBound(double h) {
        return h / (2 - h);
    }

    @Override
    protected boolean isReversible() {
        return false;
    }
}
