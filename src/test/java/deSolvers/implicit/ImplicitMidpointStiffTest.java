package deSolvers.implicit;

import deSolvers.DESolver;
import deSolvers.StiffContract;

class ImplicitMidpointStiffTest extends StiffContract {
    @Override
    protected DESolver createSolver() {
        return new ImplicitMidpointSolver();
    }

    @Override
    protected double factorAtMinusAMillion() {
        return (5e5 - 1) / (5e5 + 1);
    }

    /** Each step errs by h^2/4 y'' with the sign of the last undone: stiff order 2, and no smaller for larger L. */
    @Override
    protected double stiffOrder() {
        return 2;
    }

    /** h^2/4 = 9.8e-4. */
    @Override
    protected double stiffError() {
        return 1.2e-3;
    }

    /** Second order leaves h^2/12 t e^-t = 3.1e-6 of the slow part, twice in u; measured 6.01e-6. */
    @Override
    protected double stiffPairError() {
        return 1e-5;
    }
}
