package deSolvers;

class RK4SolverTest extends FixedStepContract {
    @Override
    protected DESolver createSolver() {
        return new RK4Solver();
    }

    @Override
    protected int order() {
        return 4;
    }

    @Override
    protected double[] oscillatorStep(double h) {
        return StepMatrixFormula.polynomial(h, 1, 1, 1.0 / 2, 1.0 / 6, 1.0 / 24);
    }
}
