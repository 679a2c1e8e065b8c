package deSolvers.implicit;

import static deSolvers.problems.Bounds.assertBelow;
import static deSolvers.problems.KnownSolutions.END_OF_ROBERTSON;
import static deSolvers.problems.KnownSolutions.END_OF_VAN_DER_POL;
import static deSolvers.problems.KnownSolutions.protheroRobinson;
import static org.junit.jupiter.api.Assertions.assertEquals;

import deSolvers.problems.Kepler;
import deSolvers.problems.KnownSolutions;
import deSolvers.problems.Oscillator;
import deSolvers.problems.ReferenceProblem;
import deSolvers.problems.WorkCurve;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * What the reference problems cost, beside SciPy's Radau.
 *
 * <p>How it was compared: SciPy 1.17.1, {@code solve_ivp(method='Radau')} with rtol from 1e-3 to 1e-10 in half decades
 * and atol = rtol/1000, as here; every column in which the right-hand side was called counted, differences for
 * Jacobians included, on both sides. The error is the largest of an entry at the end. Since the error at one time may
 * be 0 by chance, problems whose solution is known at all times were run to several ends, and their errors (root mean
 * square) and evaluations (mean) averaged, again on both sides. SciPy's (evaluations, error) stand below. Equal
 * <i>errors</i> are compared, not equal tolerances: of both curves, smoothed, over all errors that both reach
 * ({@link WorkCurve}).
 */
class RadauWorkTest {

    /** SciPy's pairs of evaluations and error, from the loosest tolerance to the tightest. */
    private static final String SCIPY = """
            Van der Pol | 2164 2.84e-5 2579 4.30e-6 3178 1.98e-6 3986 3.20e-7 5067 1.49e-7 6406 2.77e-8 8236 \
            6.00e-9 10685 1.56e-9 14110 3.66e-10 18463 9.66e-11 24257 1.83e-11 32103 5.75e-12 42345 7.54e-13 \
            56795 2.80e-13 72868 3.54e-14
            Robertson | 213 3.19e-6 234 1.67e-6 262 7.12e-7 316 1.50e-7 384 5.77e-8 474 2.12e-8 589 6.04e-9 740 \
            2.36e-9 932 1.08e-9 1193 2.17e-10 1511 6.98e-11 1974 1.48e-11 2593 3.56e-12 3373 8.79e-13 4379 \
            4.32e-13
            998/1998 | 116 5.29e-5 146 7.08e-6 181 5.41e-7 219 8.67e-8 275 1.27e-8 334 5.75e-9 437 1.68e-9 565 \
            2.92e-10 737 5.45e-11 955 1.74e-11 1250 4.28e-12 1662 8.12e-13 2201 1.84e-13 2910 2.60e-14 3920 \
            9.30e-15
            Prothero-Robinson | 45 2.18e-6 45 2.18e-6 45 2.18e-6 51 5.62e-7 52 2.94e-7 52 4.14e-7 59 4.78e-8 74 \
            8.35e-8 91 7.10e-8 114 1.33e-8 150 5.84e-8 219 1.47e-9 304 1.16e-10 328 1.21e-10 524 1.85e-11
            Kepler, e = 0.5 | 742 5.56e-3 968 1.33e-3 1194 2.85e-4 1476 7.04e-5 1859 1.80e-5 2502 3.68e-6 3319 \
            7.44e-7 4377 2.31e-7 5972 5.29e-8 7643 1.17e-8 9895 2.68e-9 13899 5.83e-10 19157 1.39e-10 24460 \
            3.48e-11 32626 7.93e-12
            oscillator | 278 1.60e-4 360 3.68e-5 465 8.80e-6 606 2.08e-6 800 5.00e-7 1055 1.20e-7 1433 2.49e-8 \
            1899 5.91e-9 2523 1.40e-9 3347 3.37e-10 4463 7.88e-11 5832 2.07e-11 7880 4.55e-12 9938 1.42e-12 \
            13165 3.46e-13
            """;

    static Stream<Arguments> problems() {
        return Stream.of(
                problem("Van der Pol", KnownSolutions::vanDerPol, END_OF_VAN_DER_POL),
                problem("Robertson", KnownSolutions::robertson, END_OF_ROBERTSON),
                problem("998/1998", KnownSolutions::stiffPair, ends(0.9, 0.05, 5)),
                problem("Prothero-Robinson", () -> protheroRobinson(-1e6), ends(9, 0.1, 21)),
                problem("Kepler, e = 0.5", () -> new Kepler(0.5), 20),
                problem("oscillator", Oscillator::new, ends(19, 0.5, 5)));
    }

    private static double[] ends(double first, double apart, int number) {
        return IntStream.range(0, number).mapToDouble(i -> first + i * apart).toArray();
    }

    private static Arguments problem(String name, Supplier<ReferenceProblem> problem, double... ends) {
        return Arguments.of(name, problem, ends);
    }

    /** The promise is a ratio of 1.5. */
    @ParameterizedTest(name = "{0}")
    @MethodSource("problems")
    void noMoreEvaluationsThanSciPyForTheSameError(String name, Supplier<ReferenceProblem> maker, double[] ends) {
        WorkCurve theirs = WorkCurve.read(SCIPY, name);
        WorkCurve ours = new WorkCurve();
        for (int halfDecades = 6; halfDecades <= 20; halfDecades++) {
            double tolerance = StrictMath.pow(10, -halfDecades / 2.0);
            double squares = 0;
            double evaluations = 0;
            for (double end : ends) {
                ReferenceProblem problem = maker.get();
                new RadauIIASolver(tolerance, tolerance / 1000).stepState(problem, end);
                assertEquals(end, problem.getTime());
                squares += problem.error() * problem.error();
                evaluations += problem.getEvaluations();
            }
            double error = Math.sqrt(squares / ends.length);
            ours.add(evaluations / ends.length, error);
            // Measured 3.2 of the tolerance at most (the orbit, which adds its errors up), 1.2 for PR, else 0.15.
            assertBelow(5 * tolerance, error, tolerance);
        }
        // Measured 0.98, 0.96, 0.95, 0.85, 1.02, 0.99 in the order above; with the prediction from two errors 1.02 for
        // PR.
        assertBelow(1.1, ours.over(theirs));
        // Measured 1.15, 1.03, 1.13, 0.89, 1.12, 1.02, each at the end of the range; with that prediction 1.27 for PR.
        assertBelow(1.2, ours.worstOver(theirs));
    }
}
