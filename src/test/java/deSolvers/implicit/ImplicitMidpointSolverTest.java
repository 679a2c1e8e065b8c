package deSolvers.implicit;

import deSolvers.DESolver;
import deSolvers.FixedStepContract;
import deSolvers.StepMatrix;

class ImplicitMidpointSolverTest extends FixedStepContract {
    @Override
    protected DESolver createSolver() {
        return new ImplicitMidpointSolver();
    }

    @Override
    protected int order() {
        return 2;
    }

    @Override
    protected double[] oscillatorStep(double h) {
        return StepMatrix.rational(h, new double[] {1, 0.5}, new double[] {1, -0.5});
    }
}
