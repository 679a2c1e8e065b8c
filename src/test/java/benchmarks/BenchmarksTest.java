package benchmarks;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import particles.view.DataTable;

/** Tests the tables with a fake stopwatch: always 1 ms, and 3 ms for Hipparchus. */
class BenchmarksTest {
    private final List<Double> parts = new ArrayList<>();

    private static final Stopwatch STOPPED = (benchmark, what) -> what.matches("\\w+ [A-Z].*") ? 3e6
            : what.contains("by-hand") ? 0.8e6 : 1e6;

    private List<DataTable> tables(String included) {
        return new Benchmarks(name -> name.contains(included), STOPPED, STOPPED, (part, what) -> parts.add(part))
                .measure();
    }

    @Test
    void namesAreDifferent() {
        assertEquals(Benchmarks.names().size(), new HashSet<>(Benchmarks.names()).size());
        assertTrue(Benchmarks.names().contains("solver chain radau"), Benchmarks.names().toString());
    }

    @Test
    void theRatioIsTheTimeOfHipparchusOverOurs() {
        List<DataTable> tables = tables("comparison oscillator");
        assertEquals(List.of("comparison"), tables.stream().map(DataTable::name).toList());
        assertEquals(7, tables.get(0).rows().size());
        tables.get(0).rows().forEach(row -> assertEquals(3.0, row.get(row.size() - 1)));
        assertEquals("Hipparchus takes 3.0 to 3.0 times as long as ours at equal evaluations, and Hipparchus takes"
                + " 3.0 to 3.0 times as long as ours at equal error", BenchmarkTables.finding(tables));
    }

    @Test
    void aStepIsDividedByItsEvaluations() {
        DataTable table = tables("solver oscillator midpoint").get(0);
        assertEquals(List.of("oscillator", "midpoint", 2.0, 1e3 / 16, 1e6 / 32), table.rows().get(0));
    }

    @Test
    void stepsAreComparedWithLoopsByHand() {
        DataTable table = tables("steps chain").get(0);
        assertEquals(ByHand.METHODS, table.rows().stream().map(row -> row.get(1)).toList());
        assertEquals(List.of("chain", "rk4", 1e3 / 16, 0.8e3 / 16, 1.25), table.rows().get(0));
    }

    /** By hand, sums are in another order, and fma is not used. Measured: at most 6.7e-15 of the largest entry. */
    @ParameterizedTest
    @ValueSource(strings = {"oscillator", "chain", "cloth", "cloth-64"})
    void loopsByHandComputeTheSame(String name) {
        Workload workload = Workload.of(name);
        for (String method : ByHand.METHODS) {
            Run run = Run.steps(name, method, 16 * workload.deltaT(), 16);
            double[] state = new double[workload.getDimension()];
            run.outcome(workload, state);
            workload.source().getState(state);
            double error = ByHand.like(run).outcome(workload, state).error();
            assertTrue(error <= 6e-14, method + ": " + error);
        }
    }

    @Test
    void onlyIncludedBenchmarksAreMeasured() {
        List<DataTable> tables = tables("scene 02");
        assertEquals(List.of(List.of("02-one-spring", 1.0)), tables.get(0).rows());
        assertEquals(List.of(0.0), parts);
        assertEquals(1, tables.size());
    }

    @Test
    void progressGoesFromZeroToOne() {
        assertEquals(List.of("scenes", "frames"),
                List.of(tables("scene ").get(0).name(), tables("frame ").get(0).name()));
        parts.clear();
        tables("05");
        tables("scene");
        assertEquals(List.of(0.0, 0.0, 1.0 / 3, 2.0 / 3), parts);
    }

    /** JMH refuses a class that is not public, or a benchmark without a state; this test finds that early. */
    @Tag("slow")
    @Test
    void jmhTakesTheBenchmarks(@TempDir Path folder) throws IOException {
        Harness.write(folder);
        assertFalse(Files.readString(folder.resolve("META-INF/BenchmarkList")).isEmpty());
        assertTrue(Files.exists(folder.resolve("benchmarks/jmh_generated/SolveBenchmark_solve_jmhTest.class")));
    }
}
