package deSolvers;

class RK4SolverTest extends FixedStepContract {
    RK4SolverTest() {
        super(RK4Solver::new, 4, h -> StepMatrixFormula.polynomial(h, 1, 1, 1.0 / 2, 1.0 / 6, 1.0 / 24));
    }
}
