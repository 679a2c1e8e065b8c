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
import particles.ParticleSystem;
import particles.law.Effect;

/** Measures the time of an effect's forces on all its particles or springs. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
public class EffectBenchmark {
    /** The name of one of {@link EffectCases}. */
    @Param("gravity")
    public String what;

    private Effect effect;
    private double[] state;
    private double[] force;

    /** Builds a scene with the effect. */
    @Setup
    public void prepare() {
        ParticleSystem system = EffectCases.build(what);
        effect = EffectCases.effect(what, system);
        state = system.getStateArray();
        force = new double[state.length];
    }

    /** @return the forces so far, added up */
    @Benchmark
    public double[] addForces() {
        effect.addForces(state, 0, force);
        return force;
    }
}
