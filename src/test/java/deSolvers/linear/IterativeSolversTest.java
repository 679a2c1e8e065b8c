package deSolvers.linear;

import static deSolvers.problems.Bounds.assertBelow;
import static deSolvers.problems.Bounds.assertBetween;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.linear.BlockSolver.BlockJacobi;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Conjugate gradients, GMRES, and the solver that chooses between them and a factorisation. */
class IterativeSolversTest {
    private static final LinearOperator IDENTITY = (x, y) -> System.arraycopy(x, 0, y, 0, x.length);

    private final SolverWork work = new SolverWork();

    /** In exact arithmetic n iterations are enough; the condition decides how many are needed for a tolerance. */
    @Test
    void conjugateGradientsNeedIterationsAsTheRootOfTheCondition() {
        long[] iterations = new long[2];
        for (int i = 0; i < 2; i++) {
            BlockMatrix matrix = SparseCases.springs(SparseCases.grid(30), i == 0 ? 10 : 1000, true, work);
            BlockJacobi jacobi = new BlockJacobi(work);
            assertTrue(jacobi.prepare(matrix));
            double[] b = SparseCases.vector(2700);
            double[] x = new double[2700];
            long before = work.iterations;
            assertTrue(new ConjugateGradients(work).solve(matrix, jacobi, b, x, 1e-8));
            iterations[i] = work.iterations - before;
            assertTrue(SparseCases.residual(matrix, b, x) < 1e-7, "residual");
        }
        // A hundred times the condition: ten times the iterations, less what clusters of eigenvalues save.
        assertBetween(3 * iterations[0], 10 * iterations[0], iterations[1]);
    }

    @Test
    void conjugateGradientsRefuseAnIndefiniteMatrix() {
        LinearOperator indefinite = (x, y) -> {
            y[0] = x[0];
            y[1] = -x[1];
        };
        assertFalse(new ConjugateGradients(work).solve(indefinite, IDENTITY, new double[] {1, 2},
                new double[2],
                1e-8));
    }

    /** GMRES ends in at most n iterations, here 3, with the exact solution: 2 x = 2, y + z = 3, y - z = 1. */
    @Test
    void gmresSolvesASmallSystemInAsManyIterationsAsUnknowns() {
        double[] x = new double[3];
        LinearOperator a = (v, y) -> {
            y[0] = 2 * v[0];
            y[1] = v[1] + v[2];
            y[2] = v[1] - v[2];
        };
        assertTrue(new Gmres(work).solve(a, IDENTITY, new double[] {2, 3, 1}, x, 1e-12));
        assertArrayEquals(new double[] {1, 2, 1}, x, 1e-12);
        assertTrue(work.iterations <= 3);
    }

    /**
     * A rotation of all entries needs as many iterations as there are, more than the restart: no progress until then.
     */
    @Test
    void gmresSaysWhenARestartGainsNothing() {
        int n = 100;
        LinearOperator shift = (x, y) -> {
            for (int i = 0; i < n; i++) {
                y[i] = x[(i + 1) % n];
            }
        };
        double[] b = new double[n];
        b[0] = 1;
        assertFalse(new Gmres(work).solve(shift, IDENTITY, b, new double[n], 1e-8));
        assertBelow(100, work.iterations);
    }

    @Test
    void aSingularSystemIsNotSolved() {
        assertFalse(new Gmres(work).solve((v, y) -> y[1] = y[0] = v[0] + v[1], IDENTITY,
                new double[] {1, 2}, new double[2], 1e-8));
    }

    /**
     * Mild and stiff, symmetric or not, small and large: the residual is what was asked for, whichever way it is
     * solved.
     */
    @ParameterizedTest
    @CsvSource({"6, 10, true", "6, 1e6, false", "20, 10, true", "20, 10, false", "20, 1e6, true", "20, 1e6, false"})
    void theBlockSolverKeepsItsTolerance(int edge, double stiffness, boolean symmetric) {
        BlockMatrix matrix = SparseCases.springs(SparseCases.grid(edge), stiffness, symmetric, work);
        BlockSolver solver = new BlockSolver(work);
        assertTrue(solver.prepare(matrix, matrix, stiffness));
        double[] b = SparseCases.vector(3 * edge * edge);
        double[] x = new double[b.length];
        assertTrue(solver.solve(b, x, 1e-6));
        assertBelow(1e-5, SparseCases.residual(matrix, b, x));
        assertEquals(edge == 6 || stiffness > 1e5, work.factorisations > 0,
                "factorised where iterations would take longer");
    }

    /** Factors of another matrix are a preconditioner: more iterations, the same solution, until they are too old. */
    @Test
    void oldFactorsServeUntilTheyCostTooMuch() {
        BlockPattern pattern = SparseCases.grid(8);
        BlockSolver solver = new BlockSolver(work);
        double[] b = SparseCases.vector(192);
        double[] x = new double[192];
        for (double stiffness : new double[] {100, 110, 1e7}) {
            BlockMatrix matrix = SparseCases.springs(pattern, stiffness, true, work);
            assertTrue(solver.prepare(matrix, matrix, stiffness));
            assertTrue(solver.solve(b, x, 1e-8));
            assertTrue(SparseCases.residual(matrix, b, x) < 1e-7);
            assertEquals(1, work.factorisations, "for " + stiffness);
        }
        solver.forget();
        BlockMatrix matrix = SparseCases.springs(pattern, 100, true, work);
        assertTrue(solver.prepare(matrix, matrix, 100));
        assertEquals(2, work.factorisations);
    }

    /** (2 + i) x = b for every entry, with the real part's inverse as the preconditioner. */
    @ParameterizedTest
    @ValueSource(ints = {1, 5})
    void complexSystemsAreSolvedWithTheRealPreconditioner(int edge) {
        BlockMatrix matrix = SparseCases.springs(SparseCases.grid(edge), 0, true, work);
        BlockSolver solver = new BlockSolver(work);
        assertTrue(solver.prepare(matrix, matrix, 1));
        int m = 3 * edge * edge;
        double[] b = SparseCases.vector(2 * m);
        double[] x = new double[2 * m];
        assertTrue(solver.solveComplex((v, y) -> {
            for (int i = 0; i < m; i++) {
                y[i] = 2 * v[i] - v[m + i];
                y[m + i] = 2 * v[m + i] + v[i];
            }
        }, b, x, 1e-12));
        for (int i = 0; i < m; i++) {
            assertEquals((2 * b[i] + b[m + i]) / 5, x[i], 1e-11);
            assertEquals((2 * b[m + i] - b[i]) / 5, x[m + i], 1e-11);
        }
    }
}
