package particles.scene;

import static deSolvers.problems.Bounds.assertBelow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import particles.ParticleSystem;
import particles.Simulation;
import particles.energy.EnergyLedger;

/** The creatures of scenes 49, 52 and 56: how far they come, and where the work of their muscles goes. */
class CreaturesTest {
    private static String worm(String from, String to) throws IOException {
        String yaml = Files.readString(TestScenes.FOLDER.resolve("49-creeping-worm.yaml"), StandardCharsets.UTF_8);
        assertTrue(yaml.contains(from), from);
        return yaml.replace(from, to);
    }

    /** The mean x of all particles, which weigh the same (m). */
    private static double place(ParticleSystem system) {
        int count = system.getParticles().count();
        double sum = 0;
        for (int i = 0; i < count; i++) {
            sum += system.getOwnState()[6 * i];
        }
        return sum / count;
    }

    private static double way(String yaml) {
        Scene scene = TestScenes.build(yaml);
        double before = place(scene.system());
        scene.simulation().run();
        return place(scene.system()) - before;
    }

    /** Measured: 2.876 m in ten periods, by 2.4 m of worm; 2.726 m with a fifth of the friction. */
    @Test
    void theWaveAndNotFrictionSetsTheDirectionOfTheWorm() throws IOException {
        double way = way(worm("wavelength", "wavelength"));
        assertEquals(2.876, way, 0.05);
        double back = way(worm("wavelength: 1.2", "wavelength: 1.2, direction: [-1, 0, 0]"));
        assertEquals(-way, back, 0.01);                     // measured 2e-5: the worm is its own mirror image
        assertEquals(0.95 * way, way(worm("coefficient: 0.6", "coefficient: 0.12")), 0.05 * way);
    }

    /** A standing wave that is its own mirror image carries the worm nowhere, whatever its muscles do. */
    @Test
    void aSymmetricWaveCarriesTheWormNowhere() throws IOException {
        String standing = worm("amplitude: 0.4, period: 1, wavelength: 1.2", "amplitude: 0.1, period: 1");
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

    /** Ten seconds of walking; measured 0.67 m in each period. It falls if the period is 2 s. */
    @Test
    void theWalkerWalksAndFallsIfItsStepsTakeTooLong() throws IOException {
        String yaml = Files.readString(TestScenes.FOLDER.resolve("52-walker.yaml"), StandardCharsets.UTF_8);
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
