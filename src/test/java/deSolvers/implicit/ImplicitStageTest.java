package deSolvers.implicit;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.DESolverException;
import deSolvers.JacobianStateSource;
import deSolvers.linear.ImplicitWork;
import deSolvers.problems.Chain;
import deSolvers.problems.PlainSource;
import deSolvers.problems.Pole;
import deSolvers.problems.ReferenceProblem;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** How the stage equation is solved: what Newton's method reaches, what it refuses, and each kind of linear system. */
class ImplicitStageTest {

    @Test
    void newtonSolvesToRounding() {
        Pole square = new Pole();
        new BackwardEulerSolver().stepState(square, 0.1875);
        // m = 1 + 0.1875 m^2: m = (1 - sqrt(1 - 0.75)) / 0.375 = 4/3; measured 2.2e-16
        assertEquals(4.0 / 3, square.state()[0], 1e-15);
        square.startAt(0);
        new ImplicitMidpointSolver().stepState(square, 0.375);
        assertEquals(2 * 4.0 / 3 - 1, square.state()[0], 2e-15);
    }

    @Test
    void anEquationWithoutASolutionIsAnErrorWithTheResidual() {
        Pole square = new Pole();
        DESolverException e = assertThrows(DESolverException.class, () -> new BackwardEulerSolver().stepState(square,
                0.3));
        assertTrue(e.getMessage().contains("did not converge") && e.getMessage().contains("residual"), e.getMessage());
        assertArrayEquals(new double[] {1}, square.state());
        assertEquals(0, square.getTime());
        BackwardEulerSolver solver = new BackwardEulerSolver();
        assertThrows(DESolverException.class, () -> solver.stepState(square, 0.3));
        solver.stepState(square, 0.1875);                   // and it works again
        assertEquals(4.0 / 3, square.state()[0], 1e-15);
    }

    /** The chain, with its Jacobian. */
    private static double[] multiply(double[] w, double[] product) {
        for (int i = 0; i < w.length; i += 2) {
            product[i] = w[i + 1];
            product[i + 1] = (i == 0 ? 0 : w[i - 2]) - 2 * w[i] + (i + 2 == w.length ? 0 : w[i + 2]);
        }
        return product;
    }

    /** Hides from a solver all but the plain source and its products. */
    private static final class WithProducts extends PlainSource implements JacobianStateSource {
        WithProducts(Chain chain) {
            super(chain);
        }

        @Override
        public void getJacobianProduct(double[] direction, double[] product) {
            multiply(direction, product);
        }
    }

    /**
     * A mode keeps its shape and is multiplied by R(i h omega), for any size, by differences or the source's products:
     * the full matrix up to a state of 600, GMRES beyond.
     */
    @ParameterizedTest
    @CsvSource({"1, false", "1, true", "40, false", "40, true", "300, false", "300, true", "301, false", "301, true",
        "700, false", "700, true"})
    void everyKindOfLinearSystemLeadsToTheSameStep(int n, boolean products) {
        Chain chain = new Chain(n, (n + 1) / 2);
        double h = 20;
        double[] before = chain.state();
        BackwardEulerSolver solver = new BackwardEulerSolver();
        solver.stepState(products ? new WithProducts(chain) : chain, h);
        double[] after = chain.state();
        double z = h * chain.omega();
        double worst = 0;
        for (int i = 0; i < after.length; i += 2) {
            worst = Math.max(worst, Math.abs(after[i] - before[i] / (1 + z * z)));
            worst = Math.max(worst, Math.abs(after[i + 1] + before[i] * z * chain.omega() / (1 + z * z)));
        }
        // Measured 1.4e-15 at most with a matrix, 5.7e-15 with GMRES, 3.7e-12 where a difference stands for the
        // product.
        assertTrue(worst < (products || 2 * n <= ImplicitStage.LARGEST_DENSE ? 2e-14 : 1e-11), "error " + worst);
        ImplicitWork work = solver.getWork();
        boolean dense = 2 * n <= ImplicitStage.LARGEST_DENSE;
        assertEquals(dense ? 1 : 0, work.factorisations());
        assertEquals(dense, work.krylovIterations() == 0);
        assertEquals(products, work.products() > 0);
        assertTrue(work.newtonIterations() <= 3, work.toString());
        // One evaluation for each column or product, and four for Newton's iteration; where the mode has nodes, whose
        // entries are
        // rounding, one more, and six products to find that out (measured 5).
        int most = 2 * n == 602 ? 5 : 4;
        assertTrue(chain.evaluations() <= most + (products ? 0 : dense ? 2 * n : work.krylovIterations() + 16),
                chain.evaluations() + ": " + work);
    }

    @Test
    void aNonlinearLargeSystemIsSolvedLikeASmallOne() {
        for (int n : new int[] {4, 2000}) {
            Pendulums pendulums = new Pendulums(n);
            new BackwardEulerSolver().stepState(pendulums, 3);
            double[] state = pendulums.state();
            double worst = 0;
            for (int i = 0; i < state.length; i += 2) {
                double start = pendulums.exactState(0)[i];
                worst = Math.max(worst, Math.abs(state[i] - start - 3 * state[i + 1]));
                worst = Math.max(worst, Math.abs(state[i + 1] + 3 * StrictMath.sin(state[i])));
            }
            // The step's own equations: measured 6.7e-16 with a matrix, 4.4e-16 with GMRES.
            assertTrue(worst < 4e-15, n + ": " + worst);
        }
    }

    /** Pendulums x'' = -sin x, released at rest from angles up to 3. */
    private static final class Pendulums extends ReferenceProblem {
        Pendulums(int n) {
            super(start(2 * n));
        }

        private static double[] start(int size) {
            double[] start = new double[size];
            for (int i = 0; i < start.length; i += 2) {
                start[i] = 3.0 * (i + 1) / start.length;
            }
            return start;
        }

        @Override
        protected void rates(double t, double[] s, double[] dSdt) {
            for (int i = 0; i < s.length; i += 2) {
                dSdt[i] = s[i + 1];
                dSdt[i + 1] = -StrictMath.sin(s[i]);
            }
        }
    }
}
