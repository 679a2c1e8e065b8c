package deSolvers.implicit;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.linear.ImplicitWork;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Newton's method on equations of one unknown each, where every iterate can be told beforehand. */
class NewtonTest {

    private final ImplicitWork.Counter work = new ImplicitWork.Counter();
    private final Newton newton = new Newton(work);

    private boolean solve(NewtonProblem problem, double[] u) {
        return newton.solve(problem, u, u.clone());
    }

    @Test
    void aLinearEquationTakesOneCorrection() {
        EquationsOfOne problem = new EquationsOfOne(2, u -> 6 - 2 * u, u -> 2);
        double[] u = {1, -5};
        assertTrue(solve(problem, u));
        assertArrayEquals(new double[] {3, 3}, u);
        assertEquals(List.of(1.0, 3.0), problem.asked);
        assertEquals(1, problem.linearisations);
        assertEquals(1, work.newtonIterations);
    }

    @Test
    void aSolutionIsSeenAtOnce() {
        EquationsOfOne problem = new EquationsOfOne(2, u -> 6 - 2 * u, u -> 2);
        double[] u = {3, 3};
        assertTrue(solve(problem, u));
        assertArrayEquals(new double[] {3, 3}, u);
        assertEquals(1, problem.asked.size());
        assertEquals(0, work.newtonIterations);
        assertTrue(newton.solveLinearised(problem, u));
        assertEquals(0, problem.linearisations);
        double[] second = {3, 4};                       // the first unknown alone is not enough
        assertTrue(solve(problem, second));
        assertArrayEquals(new double[] {3, 3}, second);
    }

    /**
     * sqrt(2): quadratic, to the last bit, and each matrix is new, since none shrinks the error a hundredfold before
     * that.
     */
    @ParameterizedTest
    @ValueSource(doubles = {1, 1.4, 2, 100, -1})
    void aRootIsFoundToRounding(double start) {
        EquationsOfOne problem = new EquationsOfOne(1, u -> 2 - u * u, u -> 2 * u);
        double[] u = {start};
        assertTrue(solve(problem, u));
        assertEquals(Math.copySign(Math.sqrt(2), start), u[0], 2.3e-16);
        assertTrue(work.newtonIterations <= 12 && problem.asked.size() <= 14,
                work.newtonIterations + " " + problem.asked);
    }

    /**
     * Where the equation is almost linear one matrix does for all corrections, each a thousandth of the last or less.
     */
    @Test
    void aMatrixThatServesIsKept() {
        EquationsOfOne problem = new EquationsOfOne(1, u -> 1 - u - 1e-4 * u * u * u, u -> 1 + 3e-4 * u * u);
        double[] u = {0};
        assertTrue(solve(problem, u));
        assertEquals(0, 1 - u[0] - 1e-4 * u[0] * u[0] * u[0], 2.3e-16);
        assertEquals(1, problem.linearisations);
        assertTrue(work.newtonIterations >= 3, "corrections " + work.newtonIterations);
        // A tenth of the slope too much: every correction leaves a ninth of it or more, and the matrix is made anew.
        EquationsOfOne bent = new EquationsOfOne(1, v -> 1 - v - 0.1 * v * v * v, v -> 1 + 0.3 * v * v);
        u[0] = 0;
        work.newtonIterations = 0;
        assertTrue(solve(bent, u));
        assertEquals(0, 1 - u[0] - 0.1 * u[0] * u[0] * u[0], 2.3e-16);
        assertTrue(bent.linearisations > 1 && bent.linearisations <= work.newtonIterations,
                bent.linearisations + " matrices");
    }

    /** From 2 a whole correction of the arc tangent goes to -3.54, and from there farther: half of it comes nearer. */
    @Test
    void aCorrectionThatLeadsAwayIsDamped() {
        EquationsOfOne problem = new EquationsOfOne(1, u -> -StrictMath.atan(u), u -> 1 / (1 + u * u));
        double[] u = {2};
        assertTrue(solve(problem, u));
        assertEquals(0, u[0], 1e-20);                   // measured 1.6e-21: it converges cubically there
        double whole = 2 - 5 * StrictMath.atan(2);
        assertEquals(whole, problem.asked.get(1), 1e-15);
        assertEquals((2 + whole) / 2, problem.asked.get(2), 1e-15);
        problem.asked.clear();
        u[0] = 1;                                       // from here it converges by itself: -0.57, 0.117, ...
        assertTrue(solve(problem, u));
        assertEquals(1 - 2 * StrictMath.atan(1), problem.asked.get(1), 1e-15);
        assertEquals(0.11685990, Math.abs(problem.asked.get(2)), 5e-9);        // as many digits as it is written with
    }

    @Test
    void withoutASolutionItEndsAndSaysHowFarItGot() {
        EquationsOfOne problem = new EquationsOfOne(1, u -> -1 - u * u, u -> 2 * u);
        double[] u = {3};
        assertFalse(solve(problem, u));
        assertTrue(work.newtonIterations <= 50 && work.newtonIterations > 1, "iterations " + work.newtonIterations);
        String[] words = newton.describeFailure().split(" ");
        assertTrue(newton.describeFailure().matches("Newton's iteration did not converge: after "
                + work.newtonIterations
                + " iterations the correction is \\S+ of the unknowns \\(limit 1e-10\\) and the largest residual"
                + " [1-9]\\S*"),
                newton.describeFailure());
        assertTrue(Double.parseDouble(words[words.length - 1]) >= 1, "1 + u^2 is");
    }

    /**
     * Residuals that do not fall, from far off the tolerance: 1, 1/2, ... 1/256 of the correction is tried, and no
     * more.
     */
    @Test
    void dampingHasAnEnd() {
        EquationsOfOne problem = new EquationsOfOne(1, u -> 1, u -> 1);
        double[] u = {1e6};
        assertFalse(solve(problem, u));
        List<Double> expected = new ArrayList<>(List.of(1e6));
        for (double damping = 1; damping >= 1.0 / 256; damping /= 2) {
            expected.add(1e6 + damping);
        }
        assertEquals(expected, problem.asked);
        assertEquals(1e6, u[0], "and nothing of it is taken");
    }

    /**
     * What no correction improves is rounding if the corrections are within 1e-10 of the unknowns, and a failure else.
     */
    @ParameterizedTest
    @CsvSource({"1e-9, false", "1.01e-10, false", "0.99e-10, true", "1e-12, true"})
    void whatNoCorrectionImprovesIsRounding(double noise, boolean solved) {
        assertEquals(solved, solve(new EquationsOfOne(1, u -> noise, u -> 1), new double[] {1}));
        // What the residual is known to be wrong by is no residual.
        EquationsOfOne known = new EquationsOfOne(1, u -> noise, u -> 1);
        known.floor = noise;
        double[] u = {1};
        assertTrue(solve(known, u));
        assertEquals(1 + noise, u[0]);
        known.floor = Math.nextDown(noise);
        assertEquals(solved, solve(known, new double[] {1}));
    }

    /** Relative to the unknown, or to what it was. */
    @ParameterizedTest
    @CsvSource({"1, 0, 0.99e-10, true", "1, 0, 1.01e-10, false", "0, 1, 0.99e-10, true", "0, 1, 1.01e-10, false",
        "-4, 1, 3.99e-10, true", "-4, 1, 4.01e-10, false", "1e-6, 1e-9, 0.99e-16, true", "1e-6, 1e-9, 1.01e-16, false"})
    void correctionsAreJudgedBesideTheUnknowns(double value, double scale, double noise, boolean solved) {
        EquationsOfOne one = new EquationsOfOne(1, u -> noise, u -> 1);
        assertEquals(solved, newton.solve(one, new double[] {value}, new double[] {scale}));
        // A second unknown, larger by any factor, makes no difference.
        for (double large : new double[] {10, 1e6, 1e15}) {
            EquationsOfOne two = new EquationsOfOne(2, u -> Math.abs(u) == large ? 0 : noise, u -> 1);
            assertEquals(solved, newton.solve(two, new double[] {large, value}, new double[] {large, scale}));
        }
    }

    /**
     * 2 y^2 = 2e-12 beside an unknown up to 1e18 times larger: y = 1e-6 as if alone, unless its residual is rounding.
     */
    @ParameterizedTest
    @ValueSource(doubles = {1e-6, 1, 1e3, 1e6, 1e12})
    void aSmallUnknownBesideALargeOneIsRight(double large) {
        EquationsOfOne two = new EquationsOfOne(2, u -> Math.abs(u) < 1e-5 ? 2e-12 - 2 * u * u : 0, u -> 4 * u);
        double[] u = {large, 3e-6};
        assertTrue(newton.solve(two, u, u.clone()));
        assertEquals(1e-6, u[1], 1e-17);                // measured at most 1.1e-18
        EquationsOfOne rounded = new EquationsOfOne(2, v -> Math.abs(v) < 1e-5 ? 2e-12 - 2 * v * v : 0, v -> 4 * v);
        rounded.floor = 1e-11;
        double[] start = {1e12, 3e-6};
        assertTrue(newton.solve(rounded, start, start.clone()));
        assertTrue(Math.abs(start[1]) < 4e-6, "anywhere");
    }

    /**
     * An entry that should be 0 becomes smaller with each correction and never relatively exact: two rounds are enough.
     */
    @Test
    void whatShouldBeZeroDoesNotHaveToBe() {
        EquationsOfOne two = new EquationsOfOne(2, u -> u > 0.5 ? 1 - u : -u, u -> u > 0.5 ? 1 : 1 + 1e-12);
        double[] u = {2, 1e-3};
        assertTrue(newton.solve(two, u, new double[] {1, 0}));
        assertEquals(1, u[0]);
        assertTrue(Math.abs(u[1]) < 1e-26 && u[1] != 0, "left " + u[1]);        // 1e-12 of it is left each time
        assertTrue(work.newtonIterations < 8, "iterations " + work.newtonIterations);
    }

    /**
     * Beside where the largest unknown goes, too: one goes from 1 to 2, and one of 0.0015 is judged by a thousandth of
     * 2.
     */
    @Test
    void correctionsAreJudgedBesideWhereTheUnknownsGo() {
        EquationsOfOne two = new EquationsOfOne(2, u -> u == 1 ? 1 : u == 0 ? 0.0015 : Double.NaN, u -> 1);
        assertFalse(newton.solve(two, new double[] {1, 0}, new double[] {1, 0}));
        assertTrue(newton.describeFailure().contains("the correction is 0.75 of"), newton.describeFailure());
    }

    /** Nothing that is not finite is ever corrected with, and no singular matrix. */
    @Test
    void whatIsNotFiniteOrSingularIsRefused() {
        for (double bad : new double[] {Double.NaN, Double.POSITIVE_INFINITY}) {
            EquationsOfOne problem = new EquationsOfOne(1, u -> bad, u -> 1);
            assertFalse(solve(problem, new double[] {1}));
            assertFalse(newton.solveLinearised(problem, new double[] {1}));
            assertEquals(0, problem.linearisations);
        }
        EquationsOfOne singular = new EquationsOfOne(1, u -> 1, u -> 0);
        assertFalse(solve(singular, new double[] {1}));
        assertFalse(newton.solveLinearised(singular, new double[] {1}));
        // Half of the correction is finite: it is taken, and the root of log u is found.
        EquationsOfOne logarithm = new EquationsOfOne(1, u -> -StrictMath.log(u), u -> 1 / u);
        double[] u = {4};
        assertTrue(solve(logarithm, u));
        assertEquals(1, u[0], 1e-15);
    }

    /** Residuals whose square would not be a number are scaled for the linear solver, and the correction back. */
    @ParameterizedTest
    @CsvSource({"1e-200, 1", "1e-100, 1", "1.01e-100, 1.01e-100", "1, 1", "2, 2", "0.99e100, 0.99e100", "1e100, 1",
            "1e200, 1"})
    void extremeResidualsAreScaled(double size, double given) {
        EquationsOfOne problem = new EquationsOfOne(2, u -> size * (1 - u), u -> size);
        double[] u = {0, 0};
        assertTrue(newton.solveLinearised(problem, u));
        assertArrayEquals(new double[] {1, 1}, u, 3e-16);
        assertEquals(given, problem.corrected.get(0));
        assertEquals(1, work.newtonIterations);
        double[] once = {0, 0};
        assertTrue(newton.solve(problem, once, new double[] {1, 1}));
        assertArrayEquals(new double[] {1, 1}, once, 3e-16);
    }

    @Test
    void extremeResidualsAreReportedAsTheyAre() {
        assertFalse(solve(new EquationsOfOne(1, u -> 1e200, u -> 1), new double[] {1}));
        assertTrue(newton.describeFailure().endsWith("the largest residual 1.0e+200"), newton.describeFailure());
        EquationsOfOne singular = new EquationsOfOne(1, u -> 1e200, u -> 0);
        assertFalse(newton.solveLinearised(singular, new double[] {1}));
    }

    /** One correction is all that the linearised equation takes, whatever it leaves. */
    @Test
    void theLinearisedEquationIsSolvedOnce() {
        EquationsOfOne problem = new EquationsOfOne(1, u -> 2 - u * u, u -> 2 * u);
        double[] u = {1};
        assertTrue(newton.solveLinearised(problem, u));
        assertEquals(1.5, u[0]);
        assertEquals(1, problem.asked.size());
    }
}
