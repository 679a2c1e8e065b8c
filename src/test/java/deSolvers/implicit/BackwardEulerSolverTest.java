package deSolvers.implicit;

import deSolvers.DESolver;
import deSolvers.FixedStepContract;
import deSolvers.StepMatrixFormula;

class BackwardEulerSolverTest extends FixedStepContract {
    @Override
    protected DESolver createSolver() {
        return new BackwardEulerSolver();
    }

    @Override
    protected int order() {
        return 1;
    }

    @Override
    protected double[] oscillatorStep(double h) {
        return StepMatrixFormula.rational(h, new double[] {1}, new double[] {1, -1});
    }
}
