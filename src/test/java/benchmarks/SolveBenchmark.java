package benchmarks;

import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;

/** Measures the time to solve a workload from its start, by our solvers or by Hipparchus. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
public class SolveBenchmark {
    /** A {@link Run}. */
    @Param("oscillator rk4 4.0 64 NaN")
    public String what;

    private Workload workload;
    private Method method;

    /** Makes the workload and the method once. */
    @Setup
    public void prepare() {
        Run run = Run.parse(what);
        workload = Workload.of(run.workload());
        method = Method.of(run);
    }

    /** @return the clock at the end */
    @Benchmark
    public double solve() {
        method.solve(workload);
        return workload.source().getTime();
    }
}
