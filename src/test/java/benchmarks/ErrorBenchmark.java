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

/** The time in which our solvers and Hipparchus' integrators solve a workload with the same error. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
public class ErrorBenchmark {
    static final double ERROR = 1e-6;

    /** The fewest steps or the loosest tolerance that was found to end within {@link #ERROR} of the reference. */
    private static final String SETTINGS = """
            rk4                 oscillator 403     chain 160     cloth 385
            ClassicalRungeKutta oscillator 403     chain 160     cloth 385
            adams               oscillator 522     chain 232     cloth 509
            AdamsMoulton        oscillator 3.1e-9  chain 3.9e-8  cloth 1.4e-9
            dormand-prince      oscillator 1.7e-7  chain 3.9e-6  cloth 1.5e-7
            DormandPrince54     oscillator 1.3e-7  chain 3.4e-7  cloth 2.9e-8
            bulirsch-stoer      oscillator 2.2e-7  chain 3.9e-6  cloth 2.5e-7
            GraggBulirschStoer  oscillator 1.2e-6  chain 1.3e-7  cloth 2.9e-7
            """;

    /** The name of a {@link Workload}. */
    @Param({"oscillator", "chain", "cloth"})
    public String workload;

    /** A solver of our catalogue or one of Hipparchus' integrators. */
    @Param({"rk4", "ClassicalRungeKutta", "adams", "AdamsMoulton", "dormand-prince", "DormandPrince54",
        "bulirsch-stoer", "GraggBulirschStoer"})
    public String integrator;

    private Workload problem;
    private Method used;

    static Method method(String name, Workload workload) {
        String row = SETTINGS.lines().filter(line -> line.startsWith(name + " ")).findFirst().orElseThrow();
        double setting = Double.parseDouble(row.replaceFirst(".* " + workload.name() + " (\\S+).*", "$1"));
        return setting < 1 ? Method.withTolerance(name, workload.duration(), setting)
                : Method.withSteps(name, workload, workload.duration(), (int) setting);
    }

    /** Makes the workload and the method once. */
    @Setup
    public void prepare() {
        problem = Workload.of(workload);
        used = method(integrator, problem);
    }

    /** @return the clock at the end */
    @Benchmark
    public double solve() {
        used.solve(problem);
        return problem.source().getTime();
    }
}
