package deSolvers.adaptive;

class StepDoublingSolverTest extends AdaptiveContract {
    StepDoublingSolverTest() {
        super(StepDoublingSolver::new, StepDoublingSolver::new, 0.8);
    }
}
