package benchmarks;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.FieldSource;

/** Counts and errors behind the comparison, which do not depend on the machine. */
class ComparisonTest {
    static final List<Comparison.Plan> EQUAL_EVALUATIONS = Comparison.plans().stream()
            .filter(plan -> !plan.equalError())
            .toList();
    static final List<Comparison.Plan> EQUAL_ERROR = Comparison.plans().stream().filter(Comparison.Plan::equalError)
            .toList();

    @Test
    void everyPairIsThereOnEveryWorkload() {
        assertEquals(3 * 3, EQUAL_EVALUATIONS.size());
        assertEquals(3 * 4, EQUAL_ERROR.size());
    }

    /** Hipparchus evaluates once more, at the end. Errors measured equal to 9.4e-16 at most: rounding. */
    @ParameterizedTest
    @FieldSource("EQUAL_EVALUATIONS")
    void equalEvaluationsAreTheSameMethodWithTheSameSteps(Comparison.Plan plan) {
        Comparison pair = Comparison.of(plan);
        assertEquals(pair.oursFound().evaluations() + 1, pair.theirsFound().evaluations());
        assertEquals(pair.oursFound().error(), pair.theirsFound().error(), 9e-15);
        assertTrue(pair.oursFound().error() > 0, pair.toString());
    }

    @Test
    void equalErrorsAreEqualOnTheOscillator() {
        EQUAL_ERROR.stream().filter(plan -> plan.workload().equals("oscillator")).forEach(ComparisonTest::check);
    }

    @Tag("slow")
    @ParameterizedTest
    @FieldSource("EQUAL_ERROR")
    void equalErrorsAreEqual(Comparison.Plan plan) {
        check(plan);
    }

    /** Measured 2.9e-7 to 1.0e-6: the error of a method that chooses its order jumps with the tolerance. */
    private static void check(Comparison.Plan plan) {
        Comparison pair = Comparison.of(plan);
        for (double error : new double[] {pair.oursFound().error(), pair.theirsFound().error()}) {
            assertTrue(error <= Comparison.ERROR && error > Comparison.ERROR / 4, pair.toString());
        }
    }

    @Test
    void oneStepFewerMissesTheError() {
        Comparison pair = Comparison.of(EQUAL_ERROR.get(0));
        Run less = Run.steps("oscillator", "rk4", pair.ours().duration(), pair.ours().steps() - 1);
        Workload workload = Workload.of("oscillator");
        assertTrue(less.outcome(workload, workload.reference(less.duration())).error() > Comparison.ERROR,
                less.toString());
    }

    /** Against the exact solution (cos t, -sin t): measured 3.0e-13 at t = 20. */
    @Test
    void theReferenceIsFarMoreAccurateThanTheRuns() {
        double[] end = Workload.of("oscillator").reference(20);
        assertEquals(StrictMath.cos(20), end[0], 2e-12);
        assertEquals(-StrictMath.sin(20), end[1], 2e-12);
    }

    @Test
    void aRunReadsBackFromItsText() {
        for (Run run : List.of(Run.steps("chain", "rk4", 0.5, 160), Run.tolerance("cloth", "radau", 1 / 3.0, 1e-7))) {
            assertEquals(run, Run.parse(run.toString()));
        }
    }
}
