package deSolvers;

class MidpointSolverTest extends FixedStepContract {
    MidpointSolverTest() {
        super(MidpointSolver::new, 2, h -> StepMatrixFormula.polynomial(h, 1, 1, 1.0 / 2));
    }
}
