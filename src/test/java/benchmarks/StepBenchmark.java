package benchmarks;

import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;

/**
 * The time of a step of each solver, and beside the slides' solvers of loops written by hand and of Hipparchus'
 * integrators. Adaptive solvers have their own tolerances.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
public class StepBenchmark {
    static final int STEPS = 64;

    /** The name of a {@link Workload}. */
    @Param({"oscillator", "chain", "cloth"})
    public String workload;

    /** What {@link Method#withSteps} makes. */
    @Param({"euler", "euler by hand", "Euler", "midpoint", "midpoint by hand", "Midpoint", "rk4", "rk4 by hand",
        "ClassicalRungeKutta", "symplectic-euler", "symplectic-euler by hand", "step-doubling", "dormand-prince",
        "bulirsch-stoer", "adams", "verlet", "yoshida4", "backward-euler", "linearised-euler", "implicit-midpoint",
        "radau"})
    public String method;

    private Workload problem;
    private Method used;

    /** Makes the workload and the method once. */
    @Setup
    public void prepare() {
        problem = Workload.of(workload);
        used = Method.withSteps(method, problem, STEPS * problem.deltaT(), STEPS);
    }

    /** @return the clock at the end */
    @Benchmark
    @OperationsPerInvocation(STEPS)
    public double step() {
        used.solve(problem);
        return problem.source().getTime();
    }
}
