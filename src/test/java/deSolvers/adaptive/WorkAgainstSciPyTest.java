package deSolvers.adaptive;

import static deSolvers.problems.Bounds.assertAbove;
import static deSolvers.problems.KnownSolutions.growthInSeason;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.problems.DragInWind;
import deSolvers.problems.Kepler;
import deSolvers.problems.Oscillator;
import deSolvers.problems.ReferenceProblem;
import deSolvers.problems.WorkCurve;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Evaluations for the same error at the end, against RK45 of SciPy 1.17.1: solve_ivp(f, (0, T), exact(0),
 * method='RK45', rtol=tol, atol=tol) for tol = 1e-3 ... 1e-10, its nfev and the largest error of an entry at T. One
 * call of stepState over T here, the same tolerances in half decades, averaged over the errors that both reach
 * ({@link WorkCurve}).
 */
class WorkAgainstSciPyTest {
    private static final String SCIPY = """
            Kepler 0.5 | 146 8.564e-01 176 9.210e-02 254 2.768e-03 398 1.270e-04 572 2.145e-05 740 2.616e-06 \
            1166 2.874e-07 1838 2.669e-08
            Kepler 0.9 | 86 4.708e-01 122 3.670e-02 170 7.454e-03 260 8.017e-04 398 7.179e-05 608 5.720e-06 764 \
            4.396e-07 1202 3.367e-08
            DragInWind | 98 1.193e-03 146 1.079e-04 212 7.938e-06 326 8.331e-07 500 8.305e-08 788 7.994e-09 1244 \
            7.762e-10 1964 7.736e-11
            GrowthInSeason | 86 3.649e-03 140 9.179e-05 188 6.315e-06 296 1.166e-06 434 1.176e-07 596 1.294e-08 \
            902 2.244e-09 1370 9.023e-11
            Oscillator | 116 1.122e-02 182 1.127e-03 284 8.924e-05 446 6.943e-06 704 6.504e-07 1118 6.885e-08 \
            1772 7.110e-09 2804 7.231e-10
            """;

    static Stream<Arguments> problems() {
        return Stream.of(Arguments.of("Kepler 0.5", new Kepler(0.5), 12),
                Arguments.of("Kepler 0.9", new Kepler(0.9), 6),
                Arguments.of("DragInWind", new DragInWind(2, 2), 12),
                Arguments.of("GrowthInSeason", growthInSeason(), 12),
                Arguments.of("Oscillator", new Oscillator(), 20));
    }

    @ParameterizedTest
    @MethodSource("problems")
    void dormandPrinceNeedsAboutAsManyEvaluations(String name, ReferenceProblem problem, double duration) {
        double ratio = WorkCurve.of(problem, duration, tol -> new DormandPrinceSolver(tol, tol), 3, 10)
                .over(WorkCurve.read(SCIPY, name));
        // Measured 0.98, 0.95, 0.99, 0.91, 1.01 in the order above.
        assertTrue(ratio <= 1.2, name + ": " + ratio);
    }

    /** Step doubling, as on the slides, costs more than an embedded pair. */
    @ParameterizedTest
    @MethodSource("problems")
    void stepDoublingNeedsMore(String name, ReferenceProblem problem, double duration) {
        WorkCurve pair = WorkCurve.of(problem, duration, tol -> new DormandPrinceSolver(tol, tol), 3, 10);
        double plain = WorkCurve.of(problem, duration, tol -> new StepDoublingSolver(tol, tol), 3, 10).over(pair);
        // Measured 2.07, 2.46, 2.67, 1.47, 2.75.
        assertAbove(1.2, plain, name);
    }
}
