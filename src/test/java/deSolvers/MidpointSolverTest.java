package deSolvers;

class MidpointSolverTest extends FixedStepContract {
    @Override
    protected DESolver createSolver() {
        return new MidpointSolver();
    }

    @Override
    protected int order() {
        return 2;
    }

    @Override
    protected double[] oscillatorStep(double h) {
        return StepMatrixFormula.polynomial(h, 1, 1, 1.0 / 2);
    }
}
