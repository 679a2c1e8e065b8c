package particles.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Systems.onMove;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import particles.experiments.stability.SceneStability;
import particles.law.Particles;

/** Numbers that scenes state in their texts are those of their motion. */
class SceneNumbersTest {
    private static final Path SCENES = Path.of("scenes");

    /** The frequencies to which comments compare deltaT: measured within 0.4 % of the spectrum, rounded as they are. */
    @ParameterizedTest
    @CsvSource(delimiter = ';', value = {"04; omega = sqrt(k/m) = 100 rad/s; 100", "05; 2 sqrt(k/m) = 447 rad/s; 447",
            "12; 1,050 rad/s; 1050"})
    void frequenciesAreThoseOfTheSpectrum(String number, String text, double omega) throws Exception {
        Path file = SceneFiles.find(SCENES, number);
        assertTrue(Files.readString(file).contains(text), "the scene says so");
        double fastest = SceneStability.spectrum(SceneReader.read(file)).modes().get(0).size();
        assertEquals(1, fastest / omega, 0.012);
    }

    /** The same for cloths, whose spectra take some seconds each. */
    @ParameterizedTest
    @Tag("hard")
    @CsvSource(delimiter = ';', textBlock = """
            08; omega = 575 rad/s; 575
            09; omega = 670 rad/s; 670
            17; 19,000 rad/s; 19000
            20; |lambda| is 795 /s; 795
            """)
    void frequenciesOfClothsAreThoseOfTheSpectrum(String number, String text, double omega) throws Exception {
        frequenciesAreThoseOfTheSpectrum(number, text, omega);
    }

    /**
     * Kepler's third law: both bodies of a = 1 are back at their start after 2 pi s, the comet of a = 2 after
     * 2 pi 2^1.5 s. There it flies with 4.4 m/s; measured 1.9e-3 m off, which is 0.4 ms.
     */
    @Test
    void planetsAndCometReturnAfterKeplersPeriods() {
        assertReturns(2 * Math.PI, 1, 2);
        assertReturns(2 * Math.PI * Math.pow(2, 1.5), 3);
    }

    private static void assertReturns(double period, int... bodies) {
        Scene scene = scene("24", period);
        double[] start = scene.system().getOwnState().clone();
        scene.simulation().run();
        double[] end = scene.system().getOwnState();
        for (int body : bodies) {
            for (int c = Particles.STRIDE * body; c < Particles.STRIDE * body + 3; c++) {
                assertEquals(start[c], end[c], 5e-3, "body " + body);
            }
        }
    }

    /** Nearest to the sun the comet is r_a/r_p = 3.9/0.1 times as fast as farthest from it. */
    @Test
    void theCometIsThirtyNineTimesAsFastNearTheSun() {
        double[] slowest = {Double.MAX_VALUE};
        Scene scene = scene("24", 20);
        scene.simulation().addObserver(onMove(motion -> {
            double[] state = motion.getEndState();
            int v = 3 * Particles.STRIDE + 3;
            slowest[0] = Math.min(slowest[0], Math.hypot(state[v], state[v + 1]));
        }));
        scene.simulation().run();
        assertEquals(39, Math.sqrt(19.5) / slowest[0], 0.01);         // measured 39.0004
    }

    private static Scene scene(String number, double duration) {
        return SceneBuilder.build(TestScenes.named(number).withDuration(duration));
    }
}
