package deSolvers.implicit;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import deSolvers.DEStateSource;
import deSolvers.JacobianStateSource;
import deSolvers.StepTransaction;
import deSolvers.linear.Gmres;
import deSolvers.linear.ImplicitWork;
import deSolvers.problems.Law;
import deSolvers.problems.ReferenceProblem;
import java.util.Random;
import org.ejml.data.DMatrixRMaj;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The Jacobian by differences beside the one on paper: as a matrix, and as products with it. */
class JacobianDifferencesTest {
    private final ImplicitWork.Counter work = new ImplicitWork.Counter();

    /** f = size (s0 s1, s2^2 - s0, 3 s1) with a state that is told. */
    private static class Curved extends ReferenceProblem {
        private final double size;

        Curved(double size, double... at) {
            super(at);
            this.size = size;
        }

        @Override
        protected void rates(double t, double[] s, double[] dSdt) {
            dSdt[0] = size * s[0] * s[1];
            dSdt[1] = size * (s[2] * s[2] - s[0]);
            dSdt[2] = size * 3 * s[1];
        }

        double[] jacobian(double[] s) {
            return new double[] {size * s[1], size * s[0], 0, -size, 0, 2 * size * s[2], 0, 3 * size, 0};
        }
    }

    /** The same, and says what its Jacobian is. */
    private static final class Known extends Curved implements JacobianStateSource {
        Known(double size, double... at) {
            super(size, at);
        }

        @Override
        public void getJacobianProduct(double[] w, double[] product) {
            double[] j = jacobian(state());
            for (int i = 0; i < 3; i++) {
                product[i] = j[3 * i] * w[0] + j[3 * i + 1] * w[1] + j[3 * i + 2] * w[2];
            }
        }
    }

    private DMatrixRMaj dense(DEStateSource source, double[] state, double h) {
        int n = state.length;
        double[] dSdt = new double[n];
        source.setState(state);
        source.getStateDerivative(dSdt);
        DMatrixRMaj jacobian = new DMatrixRMaj(n, n);
        new DenseJacobian(work).compute(source, source, state, dSdt, h, jacobian);
        return jacobian;
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, -200, 1e-3})
    void aMatrixByDifferencesIsRightToHalfTheDigits(double size) {
        double[][] states = {{2, -3, 5}, {0, 4, -1}, {1e3, 0, 7}, {0, 0, 0}, {1e-12, 1, 1e6}};
        for (double[] state : states) {
            Curved curved = new Curved(size, state);
            for (double h : new double[] {0.1, -0.1, 1e-6}) {
                curved.startAt(0);
                double[] exact = curved.jacobian(state);
                double[] f = new double[3];
                curved.getStateDerivative(f);
                double[] differences = dense(curved, state, h).data;
                double largest = Math.max(Math.abs(state[0]), Math.max(Math.abs(state[1]), Math.abs(state[2])));
                for (int e = 0; e < 9; e++) {
                    // An entry is varied by the root of the precision of what it is or moves by; of less than 1e-5 of
                    // the
                    // largest it is not. Wrong by the curvature over that, and by what f is rounded by it: measured 1.0
                    // of it.
                    double reach = Math.max(Math.abs(state[e % 3]), Math.max(Math.abs(h * f[e % 3]), 1e-5 * largest));
                    double delta = 1.5e-8 * (reach == 0 ? 1 : reach);
                    double bound = Math.abs(size) * delta + 2.2e-16 * Math.abs(f[e / 3]) / delta;
                    assertEquals(exact[e], differences[e], 3 * bound, "entry " + e);
                }
                assertEquals(5, curved.evaluations(), "one a column, and two before");
            }
        }
        assertEquals(3 * states.length, work.jacobians);
        assertEquals(0, work.products);
    }

    @Test
    void aMatrixByProductsIsExact() {
        Known known = new Known(0.5, 2, -3, 5);
        double[] state = {1, 2, 3};                     // another one than where the source is
        DMatrixRMaj jacobian = new DMatrixRMaj(3, 3);
        new DenseJacobian(work).compute(known, known, state, new double[3], 1, jacobian);
        assertArrayEquals(known.jacobian(state), jacobian.data);
        assertEquals(0, known.evaluations());
        assertEquals(3, work.products);
        assertEquals(1, work.jacobians);
    }

    /** s' = -2 (s - 1) above 1 and -3 (s - 1) below it, and then a slope that drives it one way or the other. */
    private static Law kinked(double drive) {
        return new Law((t, s, dSdt) -> dSdt[0] = drive - (s[0] > 1 ? 2 : 3) * (s[0] - 1), 1);
    }

    /** A difference looks to where the step will go, not to where it came from. */
    @Test
    void differencesLookAhead() {
        double[] state = {1};
        assertEquals(-2, dense(kinked(1), state, 0.1).get(0), 1e-6);
        assertEquals(-3, dense(kinked(1), state, -0.1).get(0), 1e-6);
        assertEquals(-3, dense(kinked(-1), state, 0.1).get(0), 1e-6);
        assertEquals(-2, dense(kinked(-1), state, -0.1).get(0), 1e-6);
    }

    /**
     * Where all is 0 but a step moves it, that far; numbers so small that a part of them would vanish are still varied.
     */
    @Test
    void whatIsZeroOrTinyIsVariedToo() {
        double[] none = {0, 0, 0};
        assertArrayEquals(new Curved(2, none).jacobian(none), dense(new Curved(2, none), none, 1).data, 1e-7);
        double[] tiny = {1e-300, 1e-300, 0};
        assertArrayEquals(new Curved(2, tiny).jacobian(tiny), dense(new Curved(2, tiny), tiny, 1).data, 1e-7);
    }

    private DirectionalDerivative directional(DEStateSource source, double[] state, double h) {
        StepTransaction step = new StepTransaction(new BackwardEulerSolver()).begin(source, 1);
        double[] dSdt = new double[state.length];
        step.setState(state);
        step.getStateDerivative(dSdt);
        DirectionalDerivative derivative = new DirectionalDerivative(work);
        derivative.setBase(step, state, dSdt, h);
        return derivative;
    }

    /** Products of any size, in any direction; also in a state of 0, where the step or 1 tells how far to look. */
    @ParameterizedTest
    @ValueSource(doubles = {1e-6, 1, 1e6})
    void productsByDifferencesAreRightToHalfTheDigits(double length) {
        Random random = new Random(2);
        for (double[] state : new double[][] {{2, -3, 5}, {0, 0, 0}, {100, 20, -30}}) {
            Curved curved = new Curved(2, state);
            DirectionalDerivative derivative = directional(curved, state, 0.1);
            for (int n = 0; n < 5; n++) {
                double[] w = random.doubles(3, -length, length).toArray();
                double[] product = new double[3];
                derivative.multiply(w, product);
                double[] j = curved.jacobian(state);
                double largest = Math.max(1, Gmres.norm(state));
                for (int i = 0; i < 3; i++) {
                    double exact = j[3 * i] * w[0] + j[3 * i + 1] * w[1] + j[3 * i + 2] * w[2];
                    assertEquals(exact, product[i], 10 * 1.5e-8 * largest * length);     // measured 4.4 of the 10
                }
            }
            assertEquals(6, curved.evaluations());
            double[] product = {1, 2, 3};
            derivative.multiply(new double[3], product);
            assertArrayEquals(new double[3], product, "nothing is known without asking");
            assertEquals(6, curved.evaluations());
        }
    }

    /**
     * A state of 0 that moves by h f is varied by as much as that, not by 1: f = 1e-5 + 1e15 s^2 is steep farther out.
     */
    @Test
    void aStepTellsHowFarToLook() {
        Curved steep = new Curved(1, 0, 0, 0) {
            @Override
            protected void rates(double t, double[] s, double[] dSdt) {
                dSdt[0] = 1e-5 + 1e15 * s[0] * s[0];
                dSdt[1] = 0;
                dSdt[2] = 0;
            }
        };
        double[] product = new double[3];
        directional(steep, new double[3], -1e-3).multiply(new double[] {1, 0, 0}, product);
        assertEquals(1e15 * 1e-8 * 1.490116e-8, product[0], 1e-4, "the root of the precision of 1e-8");
        assertEquals(1e15 * 1e-8 * 1.490116e-8, dense(steep, new double[3], 1e-3).get(0, 0), 1e-4);
    }

    @Test
    void productsOfTheSourceAreTakenWhereItWas() {
        Known known = new Known(0.5, 2, -3, 5);
        double[] state = {1, 2, 3};
        DirectionalDerivative derivative = directional(known, state, 1);
        known.setState(new double[] {7, 8, 9});
        double[] product = new double[3];
        derivative.multiply(new double[] {0, 1, 0}, product);
        assertArrayEquals(new double[] {0.5, 0, 1.5}, product);
        assertEquals(1, work.products);
        assertEquals(1, known.evaluations());
    }
}
