package deSolvers.implicit;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.linear.ConjugateGradients;
import deSolvers.linear.Gmres;
import deSolvers.linear.ImplicitWork;
import deSolvers.linear.LinearOperator;
import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** GMRES and conjugate gradients where theory says after how many iterations they are done. */
class KrylovSolversTest {
    private static final int MANY = 1000;
    private static final LinearOperator PLAIN = LinearOperator.IDENTITY;

    private final ImplicitWork.Counter work = new ImplicitWork.Counter();
    private final Gmres gmres = new Gmres(work);
    private final ConjugateGradients gradients = new ConjugateGradients(work);
    private final Random random = new Random(4);

    private static LinearOperator diagonal(double... d) {
        return (x, y) -> Arrays.setAll(y, i -> d[i % d.length] * x[i]);
    }

    private static LinearOperator full(double[][] a) {
        return (x, y) -> {
            double[] result = new double[x.length];
            for (int i = 0; i < x.length; i++) {
                result[i] = Gmres.dot(a[i], x);
            }
            System.arraycopy(result, 0, y, 0, y.length);
        };
    }

    private double[] random(int n) {
        return random.doubles(n, -1, 1).toArray();
    }

    /** |b - A x| as a part of |b|. */
    private static double left(LinearOperator a, double[] b, double[] x) {
        double[] rest = new double[b.length];
        a.apply(x, rest);
        Arrays.setAll(rest, i -> b[i] - rest[i]);
        return Gmres.norm(rest) / Gmres.norm(b);
    }

    private double[][] shifted(int n, double shift) {
        double[][] a = new double[n][];
        for (int i = 0; i < n; i++) {
            a[i] = random(n);
            a[i][i] += shift;
        }
        return a;
    }

    private long iterations(Runnable solve) {
        long before = work.krylovIterations;
        solve.run();
        return work.krylovIterations - before;
    }

    /** Any matrix, whatever its size: an approximation that keeps the tolerance, and what is no less than it needs. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 10, 39, 40, 100, 7})
    void gmresReducesTheResidualAsAsked(int n) {
        for (double tolerance : new double[] {1e-2, 1e-6, 1e-11}) {
            LinearOperator a = full(shifted(n, 0.3 * n + 1));
            double[] b = random(n);
            double[] x = random(n);                     // what is in there does not count
            double[] inverse = {0.5, 2, -1};
            assertTrue(gmres.solve(a, PLAIN, b, x, tolerance, MANY));
            double left = left(a, b, x);
            assertTrue(left <= tolerance, n + " unknowns: " + left + " of " + tolerance);
            assertTrue(gmres.solve(a, diagonal(inverse), b, x, tolerance, MANY));
            assertTrue(left(a, b, x) <= tolerance);
        }
    }

    /**
     * As many iterations as there are different eigenvalues; one with the inverse for a preconditioner; none for b = 0.
     */
    @Test
    void asManyIterationsAsEigenvalues() {
        LinearOperator a = diagonal(1, 4, -2);
        double[] b = random(12);
        double[] x = new double[12];
        double[] expected = new double[12];
        diagonal(1, 0.25, -0.5).apply(b, expected);
        assertEquals(3, iterations(() -> assertTrue(gmres.solve(a, PLAIN, b, x, 1e-13, 3))));
        assertArrayEquals(expected, x, 1e-14);
        assertEquals(1, iterations(() -> assertTrue(gmres.solve(a, diagonal(1, 0.25, -0.5), b, x, 1e-13, MANY))));
        assertArrayEquals(expected, x, 1e-14);
        assertEquals(2, iterations(() -> assertFalse(gmres.solve(a, PLAIN, b, x, 1e-13, 2), "one too few")));
        assertTrue(left(a, b, x) < 1, "the best of two directions");
        assertEquals(0, iterations(() -> assertTrue(gmres.solve(a, PLAIN, new double[12], x, 1e-13, 0))));
        assertArrayEquals(new double[12], x);

        LinearOperator positive = diagonal(1, 4, 2);
        diagonal(1, 0.25, 0.5).apply(b, expected);
        Arrays.fill(x, 0);
        assertEquals(3, iterations(() -> assertTrue(gradients.solve(positive, PLAIN, b, x, 1e-12, 3))));
        assertArrayEquals(expected, x, 1e-14);
        assertEquals(0, iterations(() -> assertTrue(gradients.solve(positive, PLAIN, b, expected, 1e-12, 0))));
        Arrays.fill(x, 1);
        assertEquals(1, iterations(() -> assertTrue(gradients.solve(positive, diagonal(1, 0.25, 0.5), b, x, 1e-12,
                1))));
        assertArrayEquals(expected, x, 1e-14);
        Arrays.fill(x, 0);
        assertEquals(2, iterations(() -> assertFalse(gradients.solve(positive, PLAIN, b, x, 1e-12, 2))));
    }

    /**
     * A cyclic shift leaves all of the residual until the last of n iterations, and never ends where GMRES restarts
     * before.
     */
    @Test
    void gmresRestartsAfterForty() {
        for (int n : new int[] {40, 41}) {
            LinearOperator shift = (x, y) -> Arrays.setAll(y, i -> x[(i + 1) % n]);
            double[] b = new double[n];
            b[0] = 7;
            double[] x = new double[n];
            double[] expected = new double[n];
            expected[1] = 7;
            long used = iterations(() -> assertEquals(n == 40, gmres.solve(shift, PLAIN, b, x, 1e-10, MANY)));
            assertEquals(40, used, "a restart that gains nothing is the last");
            assertArrayEquals(n == 40 ? expected : new double[n], x, 1e-14);
        }
    }

    /** Where a restart gains, it goes on from where it was. */
    @Test
    void gmresGoesOnAfterARestart() {
        int n = 300;
        double[] d = new double[n];
        Arrays.setAll(d, i -> 1 + i);
        double[] b = random(n);
        double[] x = new double[n];
        long used = iterations(() -> assertTrue(gmres.solve(diagonal(d), PLAIN, b, x, 1e-9, MANY)));
        assertTrue(used > 80, used + " iterations");
        assertTrue(left(diagonal(d), b, x) <= 1e-9);
        long fewer = iterations(() -> assertFalse(gmres.solve(diagonal(d), PLAIN, b, x, 1e-9, 60)));
        assertEquals(60, fewer);
    }

    /** Of a singular matrix what can be solved is solved, and what cannot be is refused; so is what is no number. */
    @Test
    void whatCannotBeSolvedIsRefused() {
        LinearOperator singular = diagonal(2, 0);
        double[] x = new double[4];
        assertTrue(gmres.solve(singular, PLAIN, new double[] {1, 0, 3, 0}, x, 1e-12, MANY));
        assertArrayEquals(new double[] {0.5, 0, 1.5, 0}, x, 1e-15);
        assertFalse(gmres.solve(singular, PLAIN, new double[] {1, 1, 3, 0}, x, 1e-12, MANY));
        assertFalse(gmres.solve(diagonal(0), PLAIN, new double[] {1, 1, 3, 0}, x, 1e-12, MANY));
        for (double bad : new double[] {Double.NaN, Double.POSITIVE_INFINITY}) {
            assertFalse(gmres.solve(singular, PLAIN, new double[] {1, bad, 3, 0}, x, 1e-12, MANY));
            assertArrayEquals(new double[4], x);
            assertFalse(gmres.solve(diagonal(1, bad), PLAIN, new double[] {1, 2, 3, 0}, x, 1e-12, MANY));
            assertFalse(gradients.solve(diagonal(1, bad), PLAIN, new double[] {1, 2, 3, 0}, new double[4], 1e-12, 9));
            assertFalse(gradients.solve(diagonal(1), diagonal(bad), new double[] {1, 2, 3, 0}, new double[4], 1e-12,
                    9));
        }
    }

    /** Conjugate gradients say where a matrix pulls in no direction, or the wrong one; GMRES solves such a system. */
    @Test
    void conjugateGradientsNeedADefiniteMatrix() {
        for (double curvature : new double[] {-1, 0}) {
            double[] b = {1, 2};
            long used = iterations(() -> assertFalse(gradients.solve(diagonal(curvature), PLAIN, b, new double[2], 1e-9,
                    9)));
            assertEquals(1, used);
        }
        double[] x = new double[2];
        assertFalse(gradients.solve(diagonal(1), diagonal(1, -1), new double[] {1, 2}, x, 1e-9, 9),
                "nor can its inverse");
        assertFalse(gradients.solve(diagonal(1, -1), PLAIN, new double[] {1, 2}, x, 1e-9, MANY));
        assertTrue(gmres.solve(diagonal(1, -1), PLAIN, new double[] {1, 2}, x, 1e-12, MANY));
        assertArrayEquals(new double[] {1, -2}, x, 1e-15);
    }

    /** The tolerance is of the first residual, in the norm of the preconditioner: tighter ones take more iterations. */
    @Test
    void conjugateGradientsReduceTheResidualAsAsked() {
        int n = 60;
        double[][] root = shifted(n, 3);
        double[][] a = new double[n][n];
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) {
                a[i][j] = Gmres.dot(root[i], root[j]);
            }
        }
        double[] b = random(n);
        double[] start = random(n);
        double first = left(full(a), b, start);
        long before = 0;
        for (double tolerance : new double[] {1e-1, 1e-3, 1e-6}) {
            double[] x = start.clone();
            long used = iterations(() -> assertTrue(gradients.solve(full(a), PLAIN, b, x, tolerance, MANY)));
            double left = left(full(a), b, x) / first;
            assertTrue(left <= tolerance && used > before, left + " left after " + used);
            double[] fewer = start.clone();
            int one = (int) used - 1;
            assertFalse(gradients.solve(full(a), PLAIN, b, fewer, tolerance, one));
            assertTrue(left(full(a), b, fewer) / first > tolerance, "and not one more than needed");
            before = used;
        }
    }
}
