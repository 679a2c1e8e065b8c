package deSolvers.implicit;

import deSolvers.DESolver;
import deSolvers.StiffContract;

class BackwardEulerStiffTest extends StiffContract {
    @Override
    protected DESolver createSolver() {
        return new BackwardEulerSolver();
    }

    @Override
    protected double factorAtMinusAMillion() {
        return 1 / (1 + 1e6);
    }

    /** An error of h/(2 L) y'' a step, of which the next step leaves nothing. */
    @Override
    protected double stiffOrder() {
        return 1;
    }

    /** h/(2 L) = 3.1e-8. */
    @Override
    protected double stiffError() {
        return 4e-8;
    }

    /** First order leaves h/2 t e^-t = 0.0018 of the slow part, twice in u; measured 3.59e-3. */
    @Override
    protected double stiffPairError() {
        return 0.004;
    }
}
