package benchmarks;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.catalog.SolverCatalog;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.openjdk.jmh.annotations.Param;

/** Counts and errors behind the benchmarks, which do not depend on the machine. */
class BenchmarksTest {

    /** The result of a run: evaluations, and the error at the end over the largest entry of the state. */
    private record Outcome(long evaluations, double error) {
        static Outcome of(Method method, Workload workload, double[] reference) {
            long before = workload.evaluations();
            method.solve(workload);
            return new Outcome(workload.evaluations() - before, workload.error(reference));
        }
    }

    private static List<String> values(Class<?> benchmark, String parameter) throws NoSuchFieldException {
        return List.of(benchmark.getField(parameter).getAnnotation(Param.class).value());
    }

    @Test
    void everySolverIsMeasured() throws NoSuchFieldException {
        assertTrue(Set.copyOf(values(StepBenchmark.class, "method")).containsAll(SolverCatalog.names()));
    }

    private static Outcome steps(String method, String workload, int steps) {
        Workload problem = Workload.of(workload);
        double duration = steps * problem.deltaT();
        return Outcome.of(Method.withSteps(method, problem, duration, steps), problem, problem.reference(duration));
    }

    /** By hand, sums are in another order, and fma is not used. Measured: at most 6.7e-15 of the largest entry. */
    @ParameterizedTest
    @ValueSource(strings = {"oscillator", "chain", "cloth", "cloth-64"})
    void loopsByHandComputeTheSame(String workload) {
        for (String method : List.of("rk4", "midpoint", "euler", "symplectic-euler")) {
            Workload problem = Workload.of(workload);
            double duration = 16 * problem.deltaT();
            Method.withSteps(method, problem, duration, 16).solve(problem);
            double[] end = new double[problem.getDimension()];
            problem.source().getState(end);
            Method byHand = Method.withSteps(method + ByHand.SUFFIX, problem, duration, 16);
            double error = Outcome.of(byHand, problem, end).error();
            assertTrue(error <= 6e-14, method + ": " + error);
        }
    }

    /** Hipparchus evaluates once more, at the end. Errors measured equal to 9.4e-16 at most: rounding. */
    @ParameterizedTest
    @CsvSource({"euler, Euler", "midpoint, Midpoint", "rk4, ClassicalRungeKutta"})
    void theSameMethodMakesTheSameSteps(String ours, String theirs) {
        for (String workload : List.of("oscillator", "chain", "cloth")) {
            Outcome one = steps(ours, workload, 64);
            Outcome other = steps(theirs, workload, 64);
            assertEquals(one.evaluations() + 1, other.evaluations());
            assertEquals(one.error(), other.error(), 9e-15);
            assertTrue(one.error() > 0, one.toString());
        }
    }

    @Test
    void settingsEndWithTheSameErrorOnTheOscillator() throws NoSuchFieldException {
        assertErrors("oscillator");
    }

    @Tag("slow")
    @ParameterizedTest
    @ValueSource(strings = {"chain", "cloth"})
    void settingsEndWithTheSameError(String workload) throws NoSuchFieldException {
        assertErrors(workload);
    }

    /** Measured 2.9e-7 to 1.0e-6: the error of a method that chooses its order jumps with the tolerance. */
    private static void assertErrors(String workload) throws NoSuchFieldException {
        for (String method : values(ErrorBenchmark.class, "integrator")) {
            Workload problem = Workload.of(workload);
            double error = Outcome.of(ErrorBenchmark.method(method, problem), problem,
                    problem.reference(problem.duration())).error();
            assertTrue(error <= ErrorBenchmark.ERROR && error > ErrorBenchmark.ERROR / 4, method + ": " + error);
        }
    }

    /** Against the exact solution (cos t, -sin t): measured 3.0e-13 at t = 20. */
    @Test
    void theReferenceIsFarMoreAccurateThanTheRuns() {
        double[] end = Workload.of("oscillator").reference(20);
        assertEquals(StrictMath.cos(20), end[0], 2e-12);
        assertEquals(-StrictMath.sin(20), end[1], 2e-12);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            --fork=2         | unknown option -Pfork; did you mean -Pforks? allowed: -Pcheck, -Pinclude, -Pworkload, \
            -Pmethod, -Pintegrator, -Pscene, -Pforks, -Piterations, -Pmilliseconds
            --iterations=-1  | -Piterations has to be a whole number, not '-1'
            --iterations=1e3 | -Piterations has to be a whole number, not '1e3'
            --forks=         | -Pforks has to be a whole number, not ''
            --workload       | option -Pworkload needs a value: -Pworkload=...
            --workload=rope  | option -Pworkload: 'rope' is not one of: chain, cloth, cloth-256, cloth-64, oscillator
            """)
    void invalidOptionsAreRefused(String option, String message) {
        assertEquals(message, assertThrows(IllegalArgumentException.class, () -> Benchmarks.options(option))
                .getMessage());
    }
}
