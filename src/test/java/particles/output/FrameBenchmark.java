package particles.output;

import deSolvers.DESolver;
import java.util.List;
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
import particles.output.files.PngEncoder;
import particles.output.frames.FrameRenderer;
import particles.output.frames.FrameRenderer.FrameSetup;
import particles.output.painters.FrameState;
import particles.output.painters.FrameState.FrameStructure;
import particles.scene.Scene;
import particles.scene.SceneBuilder;
import particles.scene.TestScenes;
import particles.scene.format.SceneDescription.Drawing;

/** Measures the time to draw a frame of 1280 x 720 pixels and to encode it as PNG. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
public class FrameBenchmark {
    private static final int WIDTH = 1280;
    private static final int HEIGHT = 720;
    private static final int STEPS = 100;

    /** The name of a scene that has a camera. */
    @Param({"05-hanging-chain", "08-cloth", "09-cloth-in-wind"})
    public String scene;

    private FrameState state;
    private FrameRenderer renderer;

    /** Runs the scene for a while, so that there are folds and shadows. */
    @Setup
    public void prepare() {
        Scene built = SceneBuilder.build(TestScenes.named(scene));
        ParticleSystem system = built.system();
        DESolver solver = built.description().solving().create();
        for (int n = 0; n < STEPS; n++) {
            solver.stepState(system, built.description().deltaT());
        }
        state = new FrameState(system.getTime(), system.getStateArray(), FrameStructure.of(system, List.of()),
                List.of(), List.of());
        Drawing drawing = built.description().drawing();
        renderer = new FrameRenderer(new FrameSetup(drawing.camera().orElseThrow(), drawing.look(), built.scenery(),
                built.description().title(), ""), WIDTH, HEIGHT, 2);
    }

    /** @return the file */
    @Benchmark
    public byte[] draw() {
        return PngEncoder.file(WIDTH, HEIGHT, renderer.render(state));
    }
}
