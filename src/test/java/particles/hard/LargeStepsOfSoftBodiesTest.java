package particles.hard;

import static deSolvers.problems.Bounds.assertAbove;
import static deSolvers.problems.Bounds.assertBelow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.hard.HardSystems.assertFailsBefore;
import static particles.hard.HardSystems.fastest;
import static particles.hard.HardSystems.run;
import static particles.hard.HardSystems.scene;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import particles.ParticleSystem;

/**
 * A cloth let fall with the steps of a film, and a block of jelly that lies still for two minutes. Hard, because the
 * cloth's springs allow explicit steps of 1 to 2 ms, and because at rest nothing but the method decides whether
 * rounding is damped away or wakes the block up.
 */
@Tag("hard")
class LargeStepsOfSoftBodiesTest {
    private static final double FRAME = 1.0 / 30;

    private static final String CLOTH = """
            shapes:
              - cloth:
                  corner: [-1, 0, -1]
                  across: [2, 0, 0]
                  down: [0, 0, 2]
                  columns: 11
                  rows: 11
                  totalMass: 0.6
                  fixed: [top-left, top-right]
                  structural: {stiffness: 300, damping: 0.08}
                  shear: {stiffness: 100, damping: 0.03}
                  bend: {stiffness: 20, damping: 0.01}
            effects:
              - gravity
              - drag: {coefficient: 0.0008}
            """;

    private static final String JELLY = """
            shapes:
              - jelly:
                  centre: [0, 0.4, 0]
                  size: [0.8, 0.8, 0.8]
                  columns: 3
                  rows: 3
                  layers: 3
                  totalMass: 2
                  structural: {stiffness: 400, damping: 1}
                  shear: {stiffness: 200, damping: 0.5}
            effects:
              - gravity
            rules:
              - ground:
                  restitution: 0
                  friction: {law: coulomb, coefficient: 0.6}
            """;

    private static double extreme(ParticleSystem system, int sign) {
        double most = Double.NEGATIVE_INFINITY;
        for (int y = 1; y < system.getStateSize(); y += 6) {
            most = Math.max(most, sign * system.getOwnState()[y]);
        }
        return sign * most;
    }

    @ParameterizedTest
    @ValueSource(strings = {"euler", "midpoint", "rk4", "adams", "symplectic-euler"})
    void theClothExplodesInExplicitStepsOfAFrame(String solver) {
        assertFailsBefore(0.5, "kinetic energy", scene(CLOTH, solver, FRAME, 5).simulation());
    }

    /** It swings, comes nearly to rest and hangs at most 2.02 m deep (measured): 2 m of cloth plus its stretching. */
    @Test
    void theClothFallsAndHangsWithBackwardEuler() {
        ParticleSystem system = run(CLOTH, "backward-euler", FRAME, 10);
        assertEquals(-2.02, extreme(system, -1), 0.08);
        assertBelow(1, fastest(system));
    }

    /**
     * The documented limit of implicit-midpoint: it damps nothing, springs turn inside out as in {@link
     * StiffSpringsTest}, and the cloth vibrates ever more, within the energy limit, until Newton's method fails (after
     * 10.6 s, measured).
     */
    @Test
    void theClothStaysWithinTheLimitWithImplicitMidpoint() {
        ParticleSystem system = run(CLOTH, "implicit-midpoint", FRAME, 2);
        assertAbove(-4, extreme(system, -1), "the lowest particle");
    }

    /** Adaptive solvers take the steps that the cloth needs; all four agree within a millimetre. */
    @ParameterizedTest
    @ValueSource(strings = {"step-doubling", "dormand-prince", "bulirsch-stoer"})
    void theClothIsFollowedByAdaptiveSolvers(String solver) {
        ParticleSystem system = run(CLOTH, solver, FRAME, 1);
        assertEquals(-1.297, extreme(system, -1), 1e-3);
    }

    /**
     * 120 s; at 0.4 s it has settled to 0.796903 m, and it does not move by a rounding's speed, measured up to 4e-14
     * m/s. The two most expensive solvers run for twenty and for ten seconds.
     */
    @ParameterizedTest
    @CsvSource(textBlock = """
            backward-euler,    60,  120
            implicit-midpoint, 60,  120
            midpoint,          256, 120
            rk4,               256, 120
            adams,             256, 120
            symplectic-euler,  256, 120
            verlet,            256, 120
            dormand-prince,    60,  120
            step-doubling,     60,  120
            bulirsch-stoer,    60,  120
            yoshida4,          256, 20
            radau,             60,  10
            """)
    void theJellyLiesStillForTwoMinutes(String solver, double stepsASecond, double duration) {
        ParticleSystem system = run(JELLY, solver, 1 / stepsASecond, duration);
        assertEquals(0.796903, extreme(system, 1), 1e-6);
        assertEquals(0, extreme(system, -1), 1e-15);
        assertTrue(fastest(system) < (solver.equals("dormand-prince") ? 1e-7
                : 5e-13), "speed " + fastest(system));
    }

    /** Steps of 1/60 s wake it up: its fastest oscillation has 85 rad/s and is damped at 1,000 1/s and more. */
    @ParameterizedTest
    @ValueSource(strings = {"euler", "midpoint", "rk4", "adams", "symplectic-euler", "verlet", "yoshida4"})
    void theJellyExplodesOrIsRefusedInLongExplicitSteps(String solver) {
        assertFailsBefore(2, "", scene(JELLY, solver, 1.0 / 60, 10).simulation());       // measured: at most 1.24 s
    }
}
