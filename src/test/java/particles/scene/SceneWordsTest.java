package particles.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.function.BiConsumer;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import particles.Motion;
import particles.Observer;
import particles.ParticleSystem;
import particles.law.Particles;

/** Statements in scene files about their motion are true when they are run. */
class SceneWordsTest {
    /** Checks every particle at the end of every step, before rules act. */
    private static ParticleSystem run(String name, BiConsumer<ParticleSystem, Integer> look) {
        return run(SceneBuilder.build(TestScenes.named(name)), look);
    }

    private static ParticleSystem run(Scene scene, BiConsumer<ParticleSystem, Integer> look) {
        scene.simulation().addObserver(new Observer() {
            @Override
            public void moved(Motion motion) {
                for (int i = 0; i < scene.system().getParticles().count(); i++) {
                    look.accept(scene.system(), i);
                }
            }
        });
        scene.simulation().run();
        return scene.system();
    }

    private static double entry(ParticleSystem system, int i, int k) {
        return system.getOwnState()[Particles.STRIDE * i + k];
    }

    private static double speed(ParticleSystem system, int i) {
        return Math.abs(entry(system, i, 3)) + Math.abs(entry(system, i, 4)) + Math.abs(entry(system, i, 5));
    }

    /** The last marble moves until 5.046 s; then all lie where the planes meet, up to round-off. */
    @Test
    void marblesLieInTheGrooveInTheEnd() {
        double[] lastMove = {0};
        ParticleSystem system = run("13-marbles-in-a-groove",
                (s, i) -> lastMove[0] = speed(s, i) > 0 ? s.getTime() : lastMove[0]);
        assertEquals(5.046, lastMove[0], 0.02);
        for (int i = 0; i < 4; i++) {
            assertEquals(0, speed(system, i));
            assertEquals(0, Math.abs(entry(system, i, 0)) + Math.abs(entry(system, i, 1)), 1e-15);
        }
    }

    /**
     * With clamp and deltaT = 0.01 the red one keeps jumping from plane to plane, by 1.3 mm (1.5 mm before rules act);
     * the others lie still.
     */
    @Test
    void clampedImpactsLetOneMarbleJump() throws IOException {
        String text = Files.readString(Path.of("scenes", "13-marbles-in-a-groove.yaml"));
        Map<String, double[]> range = new HashMap<>();
        run(SceneBuilder.build(TestScenes.read(text.replace("impact: exact", "impact: clamp")).withDeltaT(0.01)),
                (s, i) -> {
                    if (s.getTime() > 6) {
                        double x = entry(s, i, 0);
                        range.merge(s.getParticles().id(i), new double[] {x, x},
                                (a, b) -> new double[] {Math.min(a[0], b[0]), Math.max(a[1], b[1])});
                    }
                });
        range.forEach((id, x) -> assertEquals(id.equals("red") ? 1.5e-3 : 0, x[1] - x[0], 1e-4, id));
        assertEquals(4, range.size());
    }

    /** rk4 with twice the step of adams ends 2.6 and 2.2 times as far from the exact fall. */
    @Test
    void adamsIsTwiceAsAccurateForTheSameWork() {
        double[] adams = skydivers("adams", 0.04);
        double[] rk4 = skydivers("rk4", 0.08);
        assertEquals(2.6, rk4[0] / adams[0], 0.1);
        assertEquals(2.2, rk4[1] / adams[1], 0.1);
    }

    private static double[] skydivers(String solver, double deltaT) {
        ParticleSystem system = run(SceneBuilder.build(TestScenes.named("22-skydivers").withSolver(solver)
                .withDeltaT(deltaT)), (s, i) -> { });
        double[] error = new double[2];
        for (int i = 0; i < 2; i++) {
            double terminal = Math.sqrt(system.getParticles().mass(i) * 9.81 / 0.24);
            error[i] = Math.abs(entry(system, i, 1) - 900
                    + terminal * terminal / 9.81 * Math.log(Math.cosh(9.81 * system.getTime() / terminal)));
        }
        return error;
    }

    /** 9 cm into the ground and 19 cm into the bump, and no particle leaves the picture. */
    @Test
    void particlesSinkDeeperIntoTheSofterGround() {
        Map<String, Double> lowest = new HashMap<>();
        ParticleSystem system = run("26-trampoline",
                (s, i) -> lowest.merge(s.getParticles().id(i), entry(s, i, 1), Math::min));
        assertEquals(0.09, -lowest.get("hard"), 0.005);
        assertEquals(0.19, 0.4 - lowest.get("soft"), 0.005);
        assertEquals(0.5, entry(system, 1, 0), "above the top of the bump");
    }

    /** 69 of the 527 drops that died in 6 s went down the drain: a little more than one in eight. */
    @Test
    @Tag("slow")
    void oneDropInEightGoesDownTheDrain() {
        Set<String> born = new HashSet<>();
        Set<String> drained = new HashSet<>();
        ParticleSystem system = run("27-fountain", (s, i) -> {
            born.add(s.getParticles().id(i));
            if (entry(s, i, 0) > 2) {
                drained.add(s.getParticles().id(i));
            }
        });
        int died = born.size() - system.getParticles().count();
        assertTrue(died > 500, "died: " + died);
        assertEquals(1 / 8.0, drained.size() / (double) died, 0.015);
    }
}
