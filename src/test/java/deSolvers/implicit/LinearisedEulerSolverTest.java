package deSolvers.implicit;

import deSolvers.DESolver;

/** Backward Euler with one linearised solve: the same order and, on linear problems, the same step. */
class LinearisedEulerSolverTest extends BackwardEulerSolverTest {
    @Override
    protected DESolver createSolver() {
        return new LinearisedEulerSolver();
    }
}
