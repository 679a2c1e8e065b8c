package particles.hard;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.catalog.SolverCatalog;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import particles.Rule;
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
    @CsvSource(textBlock = """
            euler,             9.6e-2,  8.5,    142,    1.29,   0.268
            midpoint,          3.2e-5,  4.2e-2, 0.15,   3.3e-3, 0
            rk4,               6.5e-9,  3.6e-3, 6.2e-3, 1.8e-4, 0
            step-doubling,     3.7e-10, 1.2e-6, 1.6e-5, 2.0e-6, 0
            dormand-prince,    4.2e-11, 1.0e-5, 4.5e-4, 2.0e-6, 0
            bulirsch-stoer,    6.1e-10, 1.5e-6, 2.3e-4, 2.3e-6, 0
            adams,             1.2e-7,  2.2e-3, 4.5e-2, 2.2e-3, 0
            symplectic-euler,  1.1e-2,  4.0e-3, 0.18,   0.40,   0.268
            verlet,            2.6e-4,  1.3e-3, 4.4e-2, 1.5e-3, 0
            yoshida4,          5.9e-7,  2.4e-3, 3.4e-2, 3.9e-3, 0
            backward-euler,    8.6e-2,  1.6,    49.3,   1.12,   0.268
            linearised-euler,  8.6e-2,  1.6,    52.1,   1.11,   0.268
            implicit-midpoint, 2.8e-5,  1.5e-3, 1.2e-2, 8.1e-3, 0
            radau,             6.2e-11, 4.1e-7, 4.4e-5, 5.2e-8, 0
            """)
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

    /** A shipped scene in which balls and walls are hard and elastic. */
    private static Scene hard(String name, double radius, double deltaT, String solver, double duration)
            throws IOException {
        StringBuilder text = new StringBuilder();
        StringBuilder rules = new StringBuilder("impact: exact\nrules:\n");
        rules.append("  - collisions: {radius: ").append(radius).append(", restitution: 1, restSpeed: 0}\n");
        for (String line : Files.readAllLines(Path.of("scenes", name + ".yaml"))) {
            if (line.contains("ballRadius")) {
                rules.append(line.replace("penaltyPlane", "plane").replaceAll("stiffness.*",
                        (line.contains("normal") ? "" : "normal: [0, 1, 0], ") + "restitution: 1, restSpeed: 0}\n"));
            } else if (!line.contains("repulsion") && !line.contains("penaltyPlane")) {
                text.append(line.replaceAll("deltaT: .*", "deltaT: " + deltaT)).append("\n");
            }
        }
        String all = text.toString().replace("effects:\n\n", "effects: []\n\n") + rules;
        return SceneBuilder.build(SceneReader.read(name, all.getBytes(StandardCharsets.UTF_8)).withSolver(solver)
                .withDuration(duration));
    }

    private static double kineticEnergy(Scene scene) {
        return scene.system().getKineticEnergy(scene.system().getOwnState());
    }

    /**
     * The same scenes with hard, elastic balls. In the gas nothing else acts, so each solver moves the balls exactly:
     * all find the same impacts, and the energy stays. On the billiard table only the drag of the cloth takes energy:
     * exp(-2 c t/m) is left, however the balls hit each other. Measured: 1.7e-4 of it with methods of order 1, 3.3e-8
     * to 6.7e-8 with order 2, at most 9e-13 with the others; energy of the gas within 4e-16.
     */
    @ParameterizedTest
    @MethodSource("deSolvers.catalog.SolverCatalog#names")
    void hardBallsLoseEnergyOnlyToDrag(String solver) throws IOException {
        Scene gas = hard("46-gas-in-a-box", 0.04, 0.01, solver, 0.5);
        double before = kineticEnergy(gas);
        gas.simulation().run();
        assertEquals(294, gas.simulation().getEvents());
        assertEquals(1, kineticEnergy(gas) / before, 1e-14);
        for (Rule rule : gas.simulation().getRules()) {
            assertTrue(rule.getViolation(gas.system()).part() < 1e-9, rule.getName());
        }
        Scene table = hard("45-billiards", 0.02857, 0.002, solver, 0.25);
        before = kineticEnergy(table);
        table.simulation().run();
        assertEquals(25, table.simulation().getEvents());
        double error = Math.abs(kineticEnergy(table) / before * Math.exp(2 * 0.1 / 0.17 * 0.25) - 1);
        boolean isOfOrderTwo = List.of("midpoint", "verlet", "implicit-midpoint").contains(solver);
        double measured = solver.endsWith("euler") ? 1.7e-4 : isOfOrderTwo ? 6.7e-8 : 9e-13;
        assertTrue(error < 1.1 * measured, "error " + error);
        assertTrue(error > measured / 3 || measured < 1e-12, "the measured error is no longer true: " + error);
    }

    /**
     * A push that begins at zero has a solution in each step, also where balls fall on others in a long one. Measured:
     * an error of -50.26 J at the start energy of 375 J; a law that jumps at first touch ended the run at 0.39 s.
     */
    @Test
    void backwardEulerLetsThePileFall() {
        Scene scene = scene(SCENES.get(3), "backward-euler", 1);
        EnergyLedger ledger = new EnergyLedger();
        scene.simulation().addObserver(ledger);
        scene.simulation().run();
        assertEquals(-50.26, ledger.getNumericalError(), 0.01);
    }

    /** No solver is missing in the table. */
    @Test
    void everySolverHasARow() {
        CsvSource table = Arrays.stream(getClass().getDeclaredMethods()).filter(method -> method.isAnnotationPresent(
                CsvSource.class)).findFirst().orElseThrow().getAnnotation(CsvSource.class);
        assertEquals(SolverCatalog.names(), table.textBlock().lines().map(row -> row.split(",")[0]).toList());
    }
}
