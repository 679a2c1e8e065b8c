package particles.scene;

import static deSolvers.problems.Bounds.assertBelow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.util.Map;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import particles.ParticleSystem;
import particles.Simulation;
import particles.energy.EnergyLedger;

/** The creatures of scenes 49, 52 and 56: how far they come, and where the work of their muscles goes. */
class CreaturesTest {
    private static final String WORM = "49-creeping-worm.yaml";

    private static String scene(String file) throws IOException {
        return Files.readString(TestScenes.FOLDER.resolve(file), StandardCharsets.UTF_8);
    }

    /** A scene with other words in it. */
    private static String scene(String file, String from, String to) throws IOException {
        String yaml = scene(file);
        assertTrue(yaml.contains(from), from);
        return yaml.replace(from, to);
    }

    private static double place(ParticleSystem system) {
        return place(system, "");
    }

    /** The mean x of the particles whose ids begin with this, which weigh the same (m). */
    private static double place(ParticleSystem system, String id) {
        return IntStream.range(0, system.getParticles().count()).filter(i -> system.getParticles().id(i).startsWith(id))
                .mapToDouble(i -> system.getOwnState()[6 * i]).average().orElseThrow();
    }

    private static double way(String yaml) {
        Scene scene = TestScenes.build(yaml);
        double before = place(scene.system());
        scene.simulation().run();
        return place(scene.system()) - before;
    }

    /** Measured: 2.876 m in ten periods, of a worm that is 2.4 m long; 2.726 m with a fifth of the friction. */
    @Test
    void theWaveAndNotFrictionSetsTheDirectionOfTheWorm() throws IOException {
        double way = way(scene(WORM));
        assertEquals(2.876, way, 0.02);
        double back = way(scene(WORM, "wavelength: 1.2", "wavelength: 1.2, direction: [-1, 0, 0]"));
        assertEquals(-way, back, 0.01);                     // measured 2e-5: the worm is its own mirror image
        assertEquals(2.726, way(scene(WORM, "coefficient: 0.6", "coefficient: 0.12")), 0.02);
    }

    /** Measured in three periods, of serpents 3 m long: 2.536 m with scales, 0.128 m without. */
    @Test
    void scalesMakeTheSerpentSlither() throws IOException {
        Scene scene = TestScenes.build(scene("50-serpent.yaml", "duration: 7.5", "duration: 4.5"));
        double scaly = place(scene.system(), "scaly");
        double smooth = place(scene.system(), "smooth");
        scene.simulation().run();
        assertEquals(2.536, place(scene.system(), "scaly") - scaly, 0.03);
        assertEquals(0.128, place(scene.system(), "smooth") - smooth, 0.03);
    }

    /** Measured in two periods, of a caterpillar 2 m long: 1.123 m, and 1e-15 m without the ratchet. */
    @Test
    void scalesAreTheCaterpillarsRatchet() throws IOException {
        assertEquals(1.123, way(twoPeriods("backward: 6, across: 6")), 0.01);
        assertEquals(0, way(twoPeriods("backward: 1, across: 1")), 1e-9);
    }

    private static String twoPeriods(String scales) throws IOException {
        return scene("51-caterpillar.yaml", "backward: 6, across: 6", scales).replaceFirst("duration: \\d+",
                "duration: 4");
    }

    /** Measured: 2.063 m; 4.320 m with one other phase; -1.952 m with all muscles in step. */
    @Test
    void fourMassesWalkAsTheirSceneSays() throws IOException {
        String file = "56-four-masses.yaml";
        assertEquals(2.063, way(scene(file)), 0.05);
        assertEquals(4.320, way(scene(file, "right, phase: 0}", "right, phase: 0.5}")), 0.05);
        assertEquals(-1.952, way(scene(file, "0.375", "0")), 0.05);
    }

    /** A standing wave that is its own mirror image. With an amplitude of 0.4 its symmetry breaks, by 2 cm in 10 s. */
    @Test
    void aSymmetricWaveCarriesTheWormNowhere() throws IOException {
        String standing = scene(WORM, "amplitude: 0.4, period: 1, wavelength: 1.2", "amplitude: 0.1, period: 1");
        Scene scene = TestScenes.build(standing);
        EnergyLedger ledger = new EnergyLedger();
        scene.simulation().addObserver(ledger);
        double before = place(scene.system());
        scene.simulation().run();
        assertTrue(ledger.getWork().get("muscles (driven)") > 0.1, ledger.getWork().toString());
        assertBelow(1e-9, Math.abs(place(scene.system()) - before));
    }

    private static Map<String, Double> workUntil(Simulation simulation, EnergyLedger ledger, double time) {
        while (simulation.getSystem().getTime() < time - 1e-9) {
            simulation.advance();
        }
        return ledger.getWork();
    }

    /** In a steady gait, what muscles give in a period is what friction, damping and impacts take. */
    @ParameterizedTest
    @CsvSource({"49, 1, 8", "56, 0.5, 6"})
    void aSteadyGaitLosesWhatItsMusclesGive(String name, double period, double start) {
        Scene scene = SceneBuilder.build(TestScenes.named(name).withDuration(start + 2 * period));
        EnergyLedger ledger = new EnergyLedger();
        scene.simulation().addObserver(ledger);
        scene.simulation().start();
        Map<String, Double> before = workUntil(scene.simulation(), ledger, start);
        Map<String, Double> after = workUntil(scene.simulation(), ledger, start + period);
        double given = after.get("muscles (driven)") - before.get("muscles (driven)");
        double all = after.keySet().stream().mapToDouble(work -> after.get(work) - before.getOrDefault(work, 0.0))
                .sum();
        assertTrue(given > 0.1, "given " + given);
        assertBelow(0.01 * given, Math.abs(all), name + ": " + given + " J given, " + all + " J left, " + after);
    }

    /** Measured: 4.49 m in 8 s, the head never below 0.87 m. It falls if the period is 2 s. */
    @Test
    void theWalkerWalksAndFallsIfItsStepsTakeTooLong() throws IOException {
        String yaml = scene("52-walker.yaml");
        Scene walks = TestScenes.build(yaml);
        double before = place(walks.system());
        walks.simulation().run();
        assertTrue(walks.system().getOwnState()[13] > 0.85, "its head is up");
        assertTrue(place(walks.system()) - before > 4, "it walks four metres");
        Scene falls = TestScenes.build(yaml.replace("period: 1.2", "period: 2"));
        falls.simulation().run();
        assertTrue(falls.system().getOwnState()[13] < 0.5, "its head is down");
    }
}
