package particles.hard;

import static deSolvers.problems.Bounds.assertBelow;
import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static particles.hard.HardSystems.fastest;
import static particles.hard.HardSystems.scene;

import deSolvers.catalog.SolverCatalog;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import particles.scene.Scene;

/**
 * A ball dropped into grooves of two planes of any steepness, rough by any amount, with a speed along the groove. Hard,
 * because it turns round again and again on a side that cannot hold it, past a speed that is almost 0: there Coulomb's
 * friction turns as fast as the velocity, in ever less time, and a step has no answer that an iteration would find.
 */
@Tag("hard")
class SteepGroovesTest {
    private static final String GROOVE = """
            impact: exact
            particles:
              - {id: ball, position: [%s, 4, 0], velocity: [0, 0, %s]}
            effects:
              - gravity
            rules:
              - plane: {point: [0, 0, 0], normal: [%s, %s, 0], restitution: %s, friction: {law: coulomb,
                    coefficient: %s}}
              - plane: {point: [0, 0, 0], normal: [%s, %s, 0], restitution: %s, friction: {law: coulomb,
                    coefficient: %s}}
            """;
    private static final int GROOVES = 40;
    private static final int SEED = 5;

    /** All but euler, which gains energy in each flight, so that it bounces for ever in one of these grooves. */
    static List<String> solvers() {
        return SolverCatalog.names().stream().filter(name -> !name.equals("euler")).toList();
    }

    private static String groove(Random random) {
        double left = Math.toRadians(20 + 60 * random.nextDouble());
        double right = Math.toRadians(20 + 60 * random.nextDouble());
        double mu = 0.05 + 0.9 * random.nextDouble();
        double restitution = 0.7 * random.nextDouble();
        return String.format(Locale.ROOT, GROOVE, random.nextDouble() - 0.5, random.nextDouble() - 0.5, Math.sin(left),
                Math.cos(left), restitution, mu, -Math.sin(right), Math.cos(right), restitution, mu);
    }

    /** Every ball comes to rest, after at most about 80 events (measured), without an exception. */
    @ParameterizedTest
    @MethodSource("solvers")
    void itComesToRestWithEverySolver(String solver) {
        Random random = new Random(SEED);
        for (int k = 0; k < GROOVES; k++) {
            Scene scene = scene(groove(random), solver, 0.01, 12);
            String which = "seed " + SEED + ", groove " + k + ": ";
            assertDoesNotThrow(scene.simulation()::run, which);
            assertEquals(0, fastest(scene.system()), which + "speed");
            assertBelow(400, scene.simulation().getEvents(), which);
        }
    }
}
