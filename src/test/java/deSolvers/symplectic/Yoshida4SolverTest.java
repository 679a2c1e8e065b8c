package deSolvers.symplectic;

import static org.junit.jupiter.api.Assertions.assertEquals;

import deSolvers.DESolver;
import deSolvers.problems.ForcedOscillator;
import deSolvers.problems.Steps;
import org.junit.jupiter.api.Test;

class Yoshida4SolverTest extends SymplecticContract {
    @Override
    protected DESolver createSolver() {
        return new Yoshida4Solver();
    }

    @Override
    protected int order() {
        return 4;
    }

    /** Three matrices of verlet, with the weights to thirty digits as they are published. */
    @Override
    protected double[] oscillatorStep(double h) {
        double w1 = 1.35120719195965763404768780897;
        double w0 = -1.70241438391931526809537561794;
        return product(verlet(w1 * h), product(verlet(w0 * h), verlet(w1 * h)));
    }

    private static double[] verlet(double h) {
        double c = 1 - h * h / 2;
        return new double[] {c, h, -h * (1 - h * h / 4), c};
    }

    private static double[] product(double[] a, double[] b) {
        return new double[] {a[0] * b[0] + a[1] * b[2], a[0] * b[1] + a[1] * b[3],
            a[2] * b[0] + a[3] * b[2], a[2] * b[1] + a[3] * b[3]};
    }

    @Test
    void threeEvaluationsAStep() {
        ForcedOscillator problem = new ForcedOscillator();
        DESolver solver = createSolver();
        Steps.make(10, solver, problem, 0.125);
        assertEquals(31, problem.getEvaluations());
        solver.reset();
        solver.stepState(problem, 0.125);
        assertEquals(35, problem.getEvaluations(), "one more where the last acceleration is forgotten");
    }

    /** The trace leaves [-2, 2] where the closed form's does. */
    @Test
    void theStabilityLimit() {
        double low = 1;
        double high = 2;
        while (high - low > 1e-12) {
            double mid = (low + high) / 2;
            if (Math.abs(oscillatorStep(mid)[0]) <= 1) {
                low = mid;
            } else {
                high = mid;
            }
        }
        assertEquals(1.5734, low, 5e-5);
        assertEquals(0.0761, energyBound(0.02) / 1.6e-7, 0.00005);
    }
}
