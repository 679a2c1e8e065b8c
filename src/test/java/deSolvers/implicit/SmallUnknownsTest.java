package deSolvers.implicit;

import static deSolvers.problems.Bounds.assertBelow;
import static deSolvers.problems.KnownSolutions.robertson;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.DESolver;
import deSolvers.DESolverException;
import deSolvers.problems.Law;
import deSolvers.problems.ReferenceProblem;
import deSolvers.problems.Steps;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Small unknowns beside large ones: each is as right as if it were alone, or an exception says that it is not. */
class SmallUnknownsTest {
    /** m = s + g f(m) for a falling f, by bisection. */
    private static double root(double s, double g, DoubleUnaryOperator f, double low, double high) {
        return Steps.bisect(low, high, middle -> s + g * f.applyAsDouble(middle) > middle);
    }

    /** y' = -1e6 y^3/y0^2 beside a constant: judged by a part of the constant, 80 % off at 1e8, and unmoved at 1e12. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 1, 1e3, 1e5, 1e7, 1e8, 1e10, 1e12})
    void aDecayBesideAConstant(double constant) {
        for (double start : new double[] {1, 1e-3}) {
            DoubleUnaryOperator f = y -> -1e6 / (start * start) * y * y * y;
            Law law = new Law((t, s, dSdt) -> {
                dSdt[0] = f.applyAsDouble(s[0]);
                dSdt[1] = 0;
            }, start, constant);
            new BackwardEulerSolver().stepState(law, 0.1);
            double exact = root(start, 0.1, f, 0, start);
            assertEquals(1, law.getState()[0] / exact, 4e-13);         // measured at most 3.8e-14
            assertEquals(constant, law.getState()[1]);
            assertTrue(law.getEvaluations() <= 100, law.getEvaluations() + " evaluations");      // measured 40 to 81
        }
    }

    /** Drag of the square of the velocity, 150 million kilometres from the origin. */
    @ParameterizedTest
    @CsvSource({"0, false", "6.4e6, false", "1.5e11, false", "0, true", "6.4e6, true", "1.5e11, true"})
    void dragFarFromTheOrigin(double x, boolean midpoint) {
        double c = 1e4;
        Law law = new Law((t, s, dSdt) -> {
            dSdt[0] = s[1];
            dSdt[1] = -c * s[1] * Math.abs(s[1]);
        }, x, 0.1);
        DESolver solver = midpoint ? new ImplicitMidpointSolver() : new BackwardEulerSolver();
        solver.stepState(law, 0.1);
        double g = midpoint ? 0.05 : 0.1;
        double middle = (Math.sqrt(1 + 4 * g * c * 0.1) - 1) / (2 * g * c);
        double exact = midpoint ? 2 * middle - 0.1 : middle;
        assertEquals(1, law.getState()[1] / exact, 2e-12);             // measured at most 2.0e-13
        assertTrue(law.getEvaluations() <= 35, law.getEvaluations() + " evaluations");           // measured 20 to 29
    }

    /** v' = -5 sign v, whose equation has no solution: no distance makes one of it. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 1, 1e4, 1e6, 1e9, 1e12})
    void dryFrictionHasNoSolutionAnywhere(double x) {
        for (DESolver solver : new DESolver[] {new BackwardEulerSolver(), new ImplicitMidpointSolver()}) {
            Law law = new Law((t, s, dSdt) -> {
                dSdt[0] = s[1];
                dSdt[1] = -5 * Math.signum(s[1]);
            }, x, 0.1);
            assertThrows(DESolverException.class, () -> solver.stepState(law, 0.1));
            assertBelow(2000, law.getEvaluations());      // measured 819 to 983
        }
    }

    /**
     * A chemical step of thirty years: the middle one of three species is 1e-10 of the others, and is right or refused.
     */
    @ParameterizedTest
    @ValueSource(doubles = {1e6, 1e8, 1e9, 1e11})
    void aReactionIsSolvedForEachSpeciesOrRefused(double h) {
        ReferenceProblem robertson = robertson();
        double[] before = robertson.getState();
        new BackwardEulerSolver().stepState(robertson, h);
        double[] s = robertson.getState();
        double made = 0.04 * s[0];
        double left = before[1] - s[1] + h * (made - 1e4 * s[1] * s[2] - 3e7 * s[1] * s[1]);
        assertEquals(0, left / (h * made), 1e-14);                  // measured 1e-16
    }

    /** Pairs of a large and a small entry, 12 powers of ten apart: by differences. */
    @ParameterizedTest
    @CsvSource({"1e3, 1e-3, 1", "1e3, 1e-3, 101", "1e6, 1e-6, 301", "1e8, 1e-6, 1"})
    void smallEntriesOfALargeSystem(double large, double small, int pairs) {
        DoubleUnaryOperator f = y -> -100 * (y - small) * (1 + (y - small) * (y - small) / (small * small));
        double[] start = new double[2 * pairs];
        for (int i = 0; i < start.length; i += 2) {
            start[i] = large * (1 + i * 1e-3);
            start[i + 1] = 3 * small;
        }
        double exact = root(3 * small, 0.1, f, small, 3 * small);
        Law.Rates rates = (t, s, dSdt) -> {
            for (int i = 0; i < s.length; i += 2) {
                dSdt[i] = -50 * s[i] * (1 + s[i] * s[i] / (large * large));
                dSdt[i + 1] = f.applyAsDouble(s[i + 1]);
            }
        };
        Law law = new Law(rates, start);
        new BackwardEulerSolver().stepState(law, 0.1);
        for (int i = 1; i < start.length; i += 2) {
            assertEquals(1, law.getState()[i] / exact, 1e-12, "entry " + i);
        }
        int most = 20 * (1 + 2 * pairs);                // measured up to 30 for one pair and 3621 for 301
        assertBelow(most, law.getEvaluations());
    }

    /** The message says so if the matrix is singular: here I - h J = 0. */
    @Test
    void theLinearSolversFailureIsTold() {
        Law law = new Law((t, s, dSdt) -> dSdt[0] = s[0] + 1, 1);
        Steps.assertFails(DESolverException.class, "the linear solver failed at Newton's iteration",
                () -> new BackwardEulerSolver().stepState(law, 1));
    }
}
