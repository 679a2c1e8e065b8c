package deSolvers.adaptive;

class DormandPrinceSolverTest extends AdaptiveContract {
    DormandPrinceSolverTest() {
        super(DormandPrinceSolver::new, DormandPrinceSolver::new, 1);
    }
}
