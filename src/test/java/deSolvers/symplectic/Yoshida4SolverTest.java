package deSolvers.symplectic;

import deSolvers.StepMatrixFormula;

class Yoshida4SolverTest extends SymplecticContract {
    Yoshida4SolverTest() {
        super(Yoshida4Solver::new, 4, Yoshida4SolverTest::oscillatorStep);
    }

    /** Three matrices of verlet, with the weights to thirty digits as they are published. */
    private static double[] oscillatorStep(double h) {
        double[] outer = VelocityVerletSolverTest.oscillatorStep(1.35120719195965763404768780897 * h);
        double[] inner = VelocityVerletSolverTest.oscillatorStep(-1.70241438391931526809537561794 * h);
        return StepMatrixFormula.product(outer, StepMatrixFormula.product(inner, outer));
    }

    /** A step (a b; c a) of determinant 1 keeps b v^2 - c x^2, so that v^2 = -c/b (1 - x^2). */
    @Override
    double energyBound(double h) {
        double[] step = oscillatorStep(h);
        return Math.abs(-step[2] / step[1] - 1);
    }
}
