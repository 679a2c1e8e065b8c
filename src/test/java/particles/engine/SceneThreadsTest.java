package particles.engine;

import static deSolvers.problems.Bounds.assertAbove;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.ForceDerivatives;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import particles.law.DifferentiableEffect;
import particles.law.PerParticleEffect;
import particles.scene.Scene;
import particles.scene.SceneBuilder;
import particles.scene.SceneFiles;
import particles.scene.SceneReader;
import particles.scene.format.SceneDescription;

/**
 * Every scene has the same bits with one thread, two and three. The scenes are too small for threads to pay, so the
 * limit is set to 0 here, and the threads that took part are recorded.
 */
@Tag("slow")
class SceneThreadsTest {
    private static final int STEPS = 60;

    /** A force of 0 that records the threads that evaluate it; the caller gives another some time to come. */
    private static final class Witness implements PerParticleEffect, DifferentiableEffect {
        private static final long PATIENCE = 200_000_000;
        private final Set<String> threads = ConcurrentHashMap.newKeySet();
        private final AtomicLong patience;

        Witness(boolean alone) {
            patience = new AtomicLong(alone ? 0 : PATIENCE);
        }

        private long helpers() {
            return threads.stream().filter(name -> name.startsWith("ForkJoinPool")).count();
        }

        @Override
        public String getName() {
            return "witness";
        }

        @Override
        public void addForces(double[] state, double time, double[] force, int from, int to) {
            threads.add(Thread.currentThread().getName());
            long latest = System.nanoTime() + patience.getAndSet(0);
            while (helpers() == 0 && System.nanoTime() < latest) {
                Thread.onSpinWait();
            }
        }

        @Override
        public boolean dependsOnVelocity() {
            return false;
        }

        @Override
        public void addForceDerivatives(double[] state, double time, ForceDerivatives derivatives) {
        }
    }

    /** Returns the state and time after some steps; counts the threads other than the caller's that took part. */
    private static double[] run(SceneDescription description, int threads, int steps, int[] helpers) {
        double duration = Math.min(description.duration(), steps * description.deltaT());
        Scene scene = SceneBuilder.build(description.withDuration(duration));
        Witness witness = new Witness(threads == 1);
        scene.system().addEffect(witness);
        ParallelForces.use(scene.system().getForceSum(), threads, 0);
        scene.simulation().run();
        helpers[0] = (int) witness.helpers();
        double[] state = Arrays.copyOf(scene.system().getOwnState(), scene.system().getStateSize() + 1);
        state[state.length - 1] = scene.system().getTime();
        return state;
    }

    @Test
    void everySceneHasTheSameBitsWithAnyNumberOfThreads() throws IOException {
        int scenes = 0;
        int shared = 0;
        for (Path file : SceneFiles.list(Path.of("scenes"))) {
            SceneDescription description = SceneReader.read(file);
            int[] helpers = new int[1];
            double[] alone = run(description, 1, STEPS, helpers);
            assertEquals(0, helpers[0], file.toString());
            for (int threads = 2; threads <= 3; threads++) {
                double[] together = run(description, threads, STEPS, helpers);
                assertTrue(Arrays.equals(alone, together), file + " with " + threads + " threads");
                shared += helpers[0] > 0 ? 1 : 0;
                scenes++;
            }
            assertNotEquals(0, Arrays.compare(alone, run(description, 1, STEPS / 2, helpers)), file.toString());
        }
        assertAbove(scenes / 2, shared);     // measured 61 of 82 on a busy machine; one particle is one piece
    }
}
