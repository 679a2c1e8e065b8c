package deSolvers.implicit;

import deSolvers.DESolver;
import deSolvers.StiffContract;

/** With a tolerance that everything satisfies, every call is one step of the method. */
class RadauStiffTest extends StiffContract {
    @Override
    protected DESolver createSolver() {
        return new RadauIIASolver(1e-9, 1e30);
    }

    /** R(z) = (1 + 2z/5 + z^2/20)/(1 - 3z/5 + 3z^2/20 - z^3/60), about 3/|z|. */
    @Override
    protected double factorAtMinusAMillion() {
        double z = -1e6;
        return (1 + z * (2.0 / 5 + z / 20)) / (1 + z * (-3.0 / 5 + z * (3.0 / 20 - z / 60)));
    }

    /** The order of the stages, 3, and a factor of 1/L. */
    @Override
    protected double stiffOrder() {
        return 3;
    }

    /** Measured 3.05e-12. */
    @Override
    protected double stiffError() {
        return 5e-12;
    }

    /** Rounding: measured 2.0e-15, after 100 steps. */
    @Override
    protected double stiffPairError() {
        return 1e-14;
    }
}
