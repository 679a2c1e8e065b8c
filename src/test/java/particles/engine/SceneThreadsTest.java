package particles.engine;

import static deSolvers.problems.Bounds.assertAbove;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.ForceDerivatives;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import particles.law.DifferentiableEffect;
import particles.law.Particles;
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

    /**
     * A force of 0 that records the threads that evaluate it. If several may, whoever evaluates only some of the
     * particles waits for a second thread; else the first is mostly done before another has come.
     */
    private static final class Witness implements PerParticleEffect, DifferentiableEffect {
        private static final int LONGEST_WAIT = 50;     // sleeps; a helper may have left before the work began
        private final Set<String> threads = ConcurrentHashMap.newKeySet();
        private final Particles particles;
        private final boolean several;
        private volatile boolean shared;

        Witness(Particles particles, boolean several) {
            this.particles = particles;
            this.several = several;
        }

        @Override
        public String getName() {
            return "witness";
        }

        @Override
        public void addForces(double[] state, double time, double[] force, int from, int to) {
            threads.add(Thread.currentThread().getName());
            shared |= several && to - from < particles.count();
            for (int sleeps = 0; shared && threads.size() == 1 && sleeps < LONGEST_WAIT; sleeps++) {
                LockSupport.parkNanos(1_000_000);
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

    private int shared;

    /** Returns the state and time after some steps; counts the runs in which another thread took part. */
    private double[] run(SceneDescription description, int threads, int steps) {
        double duration = Math.min(description.duration(), steps * description.deltaT());
        Scene scene = SceneBuilder.build(description.withDuration(duration));
        Witness witness = new Witness(scene.system().getParticles(), threads > 1);
        scene.system().addEffect(witness);
        ParallelForces.use(scene.system().getForceSum(), threads, 0);
        scene.simulation().run();
        if (witness.shared || threads == 1) {
            assertEquals(witness.shared, witness.threads.size() > 1, witness.threads.toString());
        }
        shared += witness.shared ? 1 : 0;
        double[] state = Arrays.copyOf(scene.system().getOwnState(), scene.system().getStateSize() + 1);
        state[state.length - 1] = scene.system().getTime();
        return state;
    }

    @Test
    void everySceneHasTheSameBitsWithAnyNumberOfThreads() throws IOException {
        List<Path> scenes = SceneFiles.list(Path.of("scenes"));
        for (Path file : scenes) {
            SceneDescription description = SceneReader.read(file);
            double[] alone = run(description, 1, STEPS);
            for (int threads = 2; threads <= 3; threads++) {
                double[] together = run(description, threads, STEPS);
                assertTrue(Arrays.equals(alone, together), file + " with " + threads + " threads");
            }
            assertNotEquals(0, Arrays.compare(alone, run(description, 1, STEPS / 2)), file.toString());
        }
        assertAbove(1.5 * scenes.size(), shared);     // measured 78, of 41 scenes twice
    }
}
