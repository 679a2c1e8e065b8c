package deSolvers.extrapolation;

import deSolvers.adaptive.AdaptiveContract;

class BulirschStoerSolverTest extends AdaptiveContract {
    BulirschStoerSolverTest() {
        super(BulirschStoerSolver::new, BulirschStoerSolver::new, 1);
    }
}
