package deSolvers.implicit;

import deSolvers.FixedStepContract;
import deSolvers.StepMatrixFormula;

/** Backward Euler with one linearised solve: the same order and, on linear problems, the same step. */
class LinearisedEulerSolverTest extends FixedStepContract {
    LinearisedEulerSolverTest() {
        super(LinearisedEulerSolver::new, 1,
                h -> StepMatrixFormula.rational(h, new double[] {1}, new double[] {1, -1}));
    }
}
