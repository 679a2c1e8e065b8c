package deSolvers.implicit;

import deSolvers.DESolver;
import deSolvers.FixedStepContract;
import deSolvers.StepMatrixFormula;

/** Backward Euler with one linearised solve: the same order and, on linear problems, the same step. */
class LinearisedEulerTest extends FixedStepContract {
    @Override
    protected DESolver createSolver() {
        return BackwardEulerSolver.linearised();
    }

    @Override
    protected boolean takesTheArray() {
        return false;
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
