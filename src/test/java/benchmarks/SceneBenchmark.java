package benchmarks;

import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;
import particles.scene.Scene;
import particles.scene.SceneBuilder;
import particles.scene.TestScenes;

/** The time from a scene's file to a simulation that is ready to run. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
public class SceneBenchmark {
    /** The name of a scene. */
    @Param({"02-one-spring", "09-cloth-in-wind", "10-jelly-block"})
    public String scene;

    /** @return the scene, read, checked and built */
    @Benchmark
    public Scene load() {
        return SceneBuilder.build(TestScenes.named(scene));
    }
}
