package particles.hard;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.catalog.SolverCatalog;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import particles.SimulationException;
import particles.energy.EnergyLedger;
import particles.scene.Scene;
import particles.scene.SceneBuilder;
import particles.scene.SceneReader;

/** The numerical error of every solver on the shipped scenes in which balls hit each other. */
@Tag("hard")
class EverySolverOnCollidingBallsTest {
    /** The scenes, each long enough for impacts. */
    private static final List<String> SCENES = List.of("44-newtons-cradle", "45-billiards", "46-gas-in-a-box",
            "47-pile-of-balls", "48-tennis-ball-on-basketball");
    private static final double[] DURATIONS = {1, 0.18, 0.3, 0.3, 1.7};
    /** A run has the same bits everywhere; a mend of a law may change the error by less than this factor. */
    private static final double MARGIN = 3;
    /** Round-off of energies of some 4 J, in the scene where balls only fall (J). */
    private static final double ROUND_OFF = 1e-13;

    private static Scene scene(String name, String solver, double duration) {
        return SceneBuilder.build(SceneReader.read(Path.of("scenes", name + ".yaml")).withSolver(solver)
                .withDuration(duration));
    }

    /** The errors measured on the five scenes (J); 0 stands for round-off. */
    @ParameterizedTest
    @CsvSource({
        "euler,             9.6e-2,  7.95,   142,    1.29,   0.268",
        "midpoint,          3.2e-5,  3.6e-2, 0.15,   3.3e-3, 0",
        "rk4,               6.5e-9,  2.4e-3, 6.2e-3, 1.8e-4, 0",
        "step-doubling,     3.7e-10, 9.5e-5, 1.6e-5, 2.0e-6, 0",
        "dormand-prince,    4.2e-11, 1.2e-4, 4.5e-4, 2.0e-6, 0",
        "bulirsch-stoer,    6.1e-10, 5.2e-5, 2.3e-4, 2.3e-6, 0",
        "adams,             1.2e-7,  1.1e-2, 4.5e-2, 2.2e-3, 0",
        "symplectic-euler,  1.1e-2,  8.1e-3, 0.18,   0.40,   0.268",
        "verlet,            2.6e-4,  9.1e-3, 4.4e-2, 1.5e-3, 0",
        "yoshida4,          5.9e-7,  1.2e-2, 3.4e-2, 3.9e-3, 0",
        "backward-euler,    8.6e-2,  1.54,   49.3,   1.12,   0.268",
        "linearised-euler,  8.6e-2,  1.51,   52.1,   1.11,   0.268",
        "implicit-midpoint, 2.8e-5,  4.3e-3, 1.2e-2, 8.1e-3, 0",
        "radau,             6.2e-11, 3.2e-5, 4.4e-5, 5.2e-8, 0"})
    void theErrorIsThatOfItsOrder(String solver, double cradle, double billiards, double gas, double pile, double two) {
        double[] measured = {cradle, billiards, gas, pile, two};
        for (int k = 0; k < measured.length; k++) {
            Scene scene = scene(SCENES.get(k), solver, DURATIONS[k]);
            EnergyLedger ledger = new EnergyLedger();
            scene.simulation().addObserver(ledger);
            scene.simulation().run();
            double error = Math.abs(ledger.getNumericalError());
            assertTrue(error <= MARGIN * measured[k] + ROUND_OFF, SCENES.get(k) + ": " + error + " J");
            assertTrue(error >= measured[k] / 10, SCENES.get(k) + ": the measured error is no longer true: " + error);
        }
    }

    /** Balls that fall on others in one long step: Newton's iteration does not converge, and says so. */
    @Test
    void backwardEulerEndsWithTheReason() {
        SimulationException e = assertThrows(SimulationException.class, () -> scene(SCENES.get(3), "backward-euler", 1)
                .simulation().run());
        assertTrue(e.getMessage().contains("Newton's iteration did not converge"), e.getMessage());
        assertEquals(0.39, e.getTime(), 0.05);
    }

    /** No solver is missing in the table. */
    @Test
    void everySolverHasARow() {
        CsvSource table = Arrays.stream(getClass().getDeclaredMethods()).filter(method -> method.isAnnotationPresent(
                CsvSource.class)).findFirst().orElseThrow().getAnnotation(CsvSource.class);
        assertEquals(SolverCatalog.names(), Arrays.stream(table.value()).map(row -> row.split(",")[0]).toList());
    }
}
