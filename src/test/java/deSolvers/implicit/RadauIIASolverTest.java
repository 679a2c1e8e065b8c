package deSolvers.implicit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.DESolver;
import deSolvers.adaptive.AdaptiveContract;
import deSolvers.problems.Chain;
import org.junit.jupiter.api.Test;

class RadauIIASolverTest extends AdaptiveContract {
    @Override
    protected DESolver createSolver() {
        return new RadauIIASolver();
    }

    @Override
    protected DESolver createSolver(double relativeTolerance, double absoluteTolerance) {
        return new RadauIIASolver(relativeTolerance, absoluteTolerance);
    }

    /** The estimate of order 3 makes h fall with tolerance^(1/4), the error of order 5 with h^5. */
    @Override
    protected double toleranceExponent() {
        return 1.25;
    }

    @Override
    protected boolean isExplicit() {
        return false;
    }

    /**
     * The collocation polynomial has the order of the estimate, not that of the end: it keeps to the tolerance (measured
     * 0.25 of it).
     */
    @Override
    protected double inBetween(double errorAtEnd, double tolerance) {
        return tolerance;
    }

    /** Systems beyond the size of a full matrix are solved by GMRES, to the same tolerance. */
    @Test
    void aLargeSystem() {
        Chain chain = new Chain(400, 20);
        RadauIIASolver solver = new RadauIIASolver(1e-6, 1e-6);
        solver.stepState(chain, 30);
        assertTrue(chain.error() < 3e-8, "error " + chain.error());         // measured 3.5e-9
        assertEquals(0, solver.getWork().factorisations());
    }
}
