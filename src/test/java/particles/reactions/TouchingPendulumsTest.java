package particles.reactions;

import static deSolvers.problems.Bounds.assertBelow;
import static deSolvers.problems.Bounds.assertBetween;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import deSolvers.catalog.SolverInfo;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import particles.ParticleSystem;
import particles.scene.ShortRun;

/** Balls on rods that touch each other, whose contacts push with next to nothing, with implicit solvers. */
class TouchingPendulumsTest {

    /** The first of three balls falls from the side; they end as one pendulum. */
    private static final String CRADLE = """
            particles:
              - {id: h1, position: [0, 1, 0], fixed: true}
              - {id: h2, position: [0.1, 1, 0], fixed: true}
              - {id: h3, position: [0.2, 1, 0], fixed: true}
              - {id: a, position: [-0.6, 0.2, 0]}
              - {id: b, position: [0.1, 0, 0]}
              - {id: c, position: [0.2, 0, 0]}
            rods: [{from: h1, to: a}, {from: h2, to: b}, {from: h3, to: c}]
            effects: [gravity]
            rules: [collisions: {radius: 0.05, restitution: %s}]
            """;
    private static final String SHAKEN = """
            particles:
              - {id: h1, position: [0, 1, 0], fixed: true}
              - {id: h2, position: [%1$s, 1, 0], fixed: true}
              - {id: a, position: [0, 0, 0]}
              - {id: b, position: [%1$s, 0, 0]}
            rods: [{from: h1, to: a}, {from: h2, to: b}]
            effects: [gravity]
            rules:
              - collisions: {radius: 0.05, restitution: 0}
              - shake: {particle: h1, amplitude: [0.05, 0, 0], period: 0.5}
              - shake: {particle: h2, amplitude: [0.05, 0, 0], period: 0.5}
            """;

    /**
     * Backward Euler failed after 5.5 s and the midpoint rule after 18.6 s: round-off moved the hooks, and the next
     * derivative was that of round-off. Measured: balls overlap or part by 3e-8 m at most.
     */
    @ParameterizedTest
    @ValueSource(strings = {"backward-euler", "linearised-euler", "implicit-midpoint", "radau"})
    void aCradleSwingsOnAsOnePendulum(String solver) {
        for (double restitution : new double[] {0, 0.5}) {
            ShortRun run = ShortRun.of(solver + " exact 0.01 20", CRADLE.formatted(restitution));
            for (int i = 0; i < 3; i++) {
                assertArrayEquals(new double[] {0.1 * i, 1, 0, 0, 0, 0}, Arrays.copyOfRange(run.getState(), 6 * i,
                        6 * i + 6), "a hook");
                assertEquals(0, run.at(6 * i + 20), "in the plane of the swing");
            }
            assertBetween(0.1 - 1e-7, 0.1 + 1e-7, run.distance(3, 4));
            assertBetween(0.1 - 1e-7, 0.1 + 1e-7, run.distance(4, 5));
            assertBelow(0, run.getNumericalError());
        }
    }

    /** A contact with a force of round-off may push or not: which of both does not depend on what was asked before. */
    @Test
    void theSameStateHasTheSameForces() {
        ParticleSystem system = ShortRun.of("rk4 exact 0.005 0.5", SHAKEN.formatted(0.1)).getSystem();
        double[] state = system.getOwnState().clone();
        double[] first = new double[state.length];
        double[] again = new double[state.length];
        system.getStateDerivative(state, first);
        for (double speed : new double[] {-1, 1e-9, 1}) {
            double[] other = state.clone();
            other[6 * 3] += speed / 10;
            other[6 * 3 + 3] += speed;
            system.getStateDerivative(other, again);
            system.getStateDerivative(state, again);
            assertArrayEquals(first, again, "after " + speed);
        }
    }

    /** The contact pushes with nothing, so the motion is that of balls apart but for the solver's error. */
    @ParameterizedTest
    @MethodSource("deSolvers.catalog.SolverCatalog#all")
    void shakenAlikeTwoTouchingPendulumsSwingAsTwoApart(SolverInfo solver) {
        ShortRun touching = ShortRun.of(solver.name() + " exact 0.005 2", SHAKEN.formatted(0.1));
        ShortRun apart = ShortRun.of(solver.name() + " exact 0.005 2", SHAKEN.formatted(0.3));
        double[] limits = {0, 2e-3, 3.2e-5, 6.4e-8};    // by order; measured: 9e-4, 1.6e-5, 3.2e-8
        for (int k = 12; k < 18; k++) {
            assertEquals(apart.at(k), touching.at(k), limits[Math.min(3, solver.order())], solver.name());
        }
        assertEquals(0.1, touching.at(18) - touching.at(12), 1e-14);
    }
}
