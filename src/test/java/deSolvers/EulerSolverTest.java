package deSolvers;

class EulerSolverTest extends FixedStepContract {
    @Override
    protected DESolver createSolver() {
        return new EulerSolver();
    }

    @Override
    protected int order() {
        return 1;
    }

    @Override
    protected double[] oscillatorStep(double h) {
        return StepMatrixFormula.polynomial(h, 1, 1);
    }
}
