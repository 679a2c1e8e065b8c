package deSolvers.implicit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.StepTransaction;
import deSolvers.adaptive.Tolerance;
import deSolvers.linear.ImplicitWork;
import deSolvers.problems.Law;
import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The iteration for the stages of s' = f(s) with a Jacobian that is told, right or wrong. */
class RadauNewtonTest {
    private static final double H = 0.5;

    private final ImplicitWork.Counter work = new ImplicitWork.Counter();
    private final double[][] z = new double[3][1];
    private final List<Double> asked = new ArrayList<>();
    private RadauNewton newton;

    /** (mu - h J) x = b for one number J; refuses to solve one of them where it is told to. */
    private record Scalar(double jacobian, boolean real, boolean complex) implements RadauSystems {
        @Override
        public void setJacobian(StepTransaction source, double[] state, double[] slope, double offset, double h) {
            throw new UnsupportedOperationException();
        }

        @Override
        public boolean keepsJacobian() {
            return true;
        }

        @Override
        public boolean prepare(double h, double mu, double muRe, double muIm) {
            return true;
        }

        @Override
        public boolean solveReal(double[] b, double[] x) {
            x[0] = b[0] / (RadauTableau.MU - H * jacobian);
            return real;
        }

        @Override
        public boolean solveComplex(double[] b, double[] x) {
            double re = RadauTableau.MU_RE - H * jacobian;
            double im = RadauTableau.MU_IM;
            double square = re * re + im * im;
            x[0] = (b[0] * re + b[1] * im) / square;
            x[1] = (b[1] * re - b[0] * im) / square;
            return complex;
        }
    }

    private boolean solve(DoubleUnaryOperator f, double start, RadauSystems systems, Tolerance tolerance) {
        Law problem = new Law((t, s, dSdt) -> {
            asked.add(t);
            dSdt[0] = f.applyAsDouble(s[0]);
        }, start);
        newton = new RadauNewton(work, tolerance, 1);
        for (double[] stage : z) {
            stage[0] = 0;
        }
        asked.clear();
        work.newtonIterations = 0;
        StepTransaction step = new StepTransaction(new RadauIIASolver()).begin(problem, 1);
        boolean solved = newton.solve(step, systems, new double[] {start}, 0.25, H, z);
        return solved;
    }

    private boolean linear(double lambda, double jacobian, double tolerance) {
        return solve(s -> lambda * s, 2, new Scalar(jacobian, true, true), new Tolerance(tolerance, 0));
    }

    /** R(z) = (1 + 2z/5 + z^2/20)/(1 - 3z/5 + 3z^2/20 - z^3/60). */
    private static double factor(double z) {
        return (1 + z * (2.0 / 5 + z / 20)) / (1 + z * (-3.0 / 5 + z * (3.0 / 20 - z / 60)));
    }

    /**
     * A linear equation with its own Jacobian: solved at once, and seen to be at the second; each stage at its time.
     */
    @ParameterizedTest
    @ValueSource(doubles = {-1000, -1, 0.5, 1})
    void aLinearEquationIsSolvedAtOnce(double lambda) {
        assertTrue(linear(lambda, lambda, 1e-6));
        assertEquals(2 * factor(H * lambda), 2 + z[2][0], 4e-15);       // measured 4.4e-16
        assertEquals(2, newton.iterations());
        assertEquals(2, work.newtonIterations);
        assertEquals(6, asked.size());
        assertTrue(newton.rate() < 1e-13, "rate " + newton.rate());
        for (int i = 0; i < 6; i++) {
            assertEquals(0.25 + H * RadauTableau.c(i % 3), asked.get(i), 1e-16);
        }
    }

    /** Nothing moves: all corrections are 0. */
    @Test
    void restIsSeenAtOnce() {
        assertTrue(solve(s -> 0, 2, new Scalar(-3, true, true), new Tolerance(1e-6, 0)));
        assertEquals(1, newton.iterations());
        assertEquals(0, newton.rate());
        assertEquals(0, z[2][0]);
    }

    /**
     * With a Jacobian that is a little wrong it converges slowly, and what is left in the end is less than it may be.
     */
    @Test
    void anOldJacobianLeavesNoMoreThanIsAllowed() {
        int solved = 0;
        int most = 0;
        for (double tolerance : new double[] {1e-2, 1e-4, 1e-7}) {
            double allowed = Math.min(0.01, Math.sqrt(tolerance)) * tolerance * 2;
            for (double jacobian = -26; jacobian < -14; jacobian += 0.0625) {
                if (linear(-20, jacobian, tolerance)) {
                    solved++;
                    most = Math.max(most, newton.iterations());
                    double left = Math.abs(2 + z[2][0] - 2 * factor(-20 * H));
                    assertTrue(left < allowed, jacobian + ": " + left + " of " + allowed);      // measured 0.93 of it
                    assertTrue(newton.rate() > 0 && newton.rate() < 1 || jacobian == -20, "rate " + newton.rate());
                }
            }
        }
        assertTrue(solved > 120 && solved < 400, solved + " of 576");
        assertEquals(RadauNewton.MOST_ITERATIONS - 1, most, "at an even rate the last one is told beforehand");
    }

    /** It gives up after the second iteration when it sees that it will not get there, or goes away from it. */
    @Test
    void whatWillNotConvergeIsGivenUpEarly() {
        assertFalse(linear(-20, 0.5, 1e-9));
        assertEquals(2, newton.iterations(), "it diverges");
        assertTrue(newton.rate() >= 1, "rate " + newton.rate());
        assertFalse(linear(-20, -60, 1e-12));
        assertEquals(2, newton.iterations(), "too slow for six iterations");
        assertTrue(newton.rate() < 1, "rate " + newton.rate());
    }

    @Test
    void whatIsNoNumberOrCannotBeSolvedEndsIt() {
        assertFalse(solve(s -> Double.NaN, 2, new Scalar(0, true, true), new Tolerance(1e-6, 0)));
        assertEquals(1, work.newtonIterations);
        assertFalse(solve(s -> -s, 2, new Scalar(-1, false, true), new Tolerance(1e-6, 0)));
        assertFalse(solve(s -> -s, 2, new Scalar(-1, true, false), new Tolerance(1e-6, 0)));
        assertEquals(1, work.newtonIterations);
        assertFalse(solve(s -> -s, 2, new Scalar(Double.NaN, true, true), new Tolerance(1e-6, 0)));
        assertEquals(1, work.newtonIterations);
    }

    /**
     * An entry at 0 is judged by how far it moves, and by 0 only where it stays there: s' = 2 - s from 0. Without a
     * relative tolerance what may be left is a hundredth of the absolute one, or less by its ratio to where the entry
     * gets.
     */
    @Test
    void anEntryAtZeroIsJudgedByWhereItGoes() {
        for (double[] pair : new double[][] {{1e-6, 0}, {0, 1e-6}, {0, 1e-3}}) {
            for (double jacobian : new double[] {-1, -1.02, -0.98, -0.95}) {
                assertTrue(solve(s -> 2 - s, 0, new Scalar(jacobian, true, true), new Tolerance(pair[0], pair[1])));
                double end = 2 - 2 * factor(-H);
                double allowed = pair[1] + pair[0] * end;
                double left = Math.abs(z[2][0] - end);
                double part = Math.min(0.01, Math.sqrt(allowed / end));
                // Measured 0.07, 0.05 and 1.14 of it: it is a bound for w, and z = T w.
                assertTrue(left < 2 * part * allowed, jacobian + ": " + left + " of " + allowed);
                assertTrue(jacobian != -1 || newton.iterations() == 2, "the right one ends at once");
            }
        }
    }
}
