package deSolvers.implicit;

import deSolvers.FixedStepContract;
import deSolvers.StepMatrixFormula;

class BackwardEulerSolverTest extends FixedStepContract {
    BackwardEulerSolverTest() {
        super(BackwardEulerSolver::new, 1, h -> StepMatrixFormula.rational(h, new double[] {1}, new double[] {1, -1}));
    }
}
