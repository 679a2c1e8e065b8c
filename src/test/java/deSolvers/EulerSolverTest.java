package deSolvers;

class EulerSolverTest extends FixedStepContract {
    EulerSolverTest() {
        super(EulerSolver::new, 1, h -> StepMatrixFormula.polynomial(h, 1, 1));
    }
}
