package particles.hard;

import static deSolvers.problems.Bounds.assertAbove;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.hard.HardSystems.fastest;
import static particles.hard.HardSystems.run;
import static particles.hard.HardSystems.scene;

import deSolvers.catalog.SolverCatalog;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import particles.Motion;
import particles.Observer;
import particles.ParticleSystem;
import particles.Rule;
import particles.scene.Scene;

/**
 * A ball between a floor and a ceiling, and one in a groove. Hard, because a step may meet both planes, the answer to
 * one drives it into the other, and a ball that two planes hold at once has to come to rest and stay.
 */
@Tag("hard")
class BetweenPlanesTest {
    private static final String SLOT = """
            impact: %s
            particles:
              - {id: ball, position: [0, 0.5, 0], velocity: [0.3, 7, 0]}
            effects:
              - gravity
            rules:
              - plane: {point: [0, 0, 0], normal: [0, 1, 0], restitution: 1}
              - plane: {point: [0, %s, 0], normal: [0, -1, 0], restitution: 1}
            """;

    private static final String GROOVE = """
            impact: %s
            particles:
              - {id: ball, position: [-0.6, 1.6, 0]}
            effects:
              - gravity
            rules:
              - plane: {point: [0, 0, 0], normal: [1, 1.6, 0], restitution: 0.5, friction: {law: coulomb,
                    coefficient: 0.1}}
              - plane: {point: [0, 0, 0], normal: [-1, 1.6, 0], restitution: 0.5, friction: {law: coulomb,
                    coefficient: 0.1}}
            """;

    /** The lowest and highest position of the ball after rules have acted. */
    private static final class Range implements Observer {
        private double low = Double.POSITIVE_INFINITY;
        private double high = Double.NEGATIVE_INFINITY;

        @Override
        public void moved(Motion motion) {
            // before the rules: with clamp the ball may be below a plane
        }

        @Override
        public void changed(ParticleSystem system, Rule rule) {
            low = Math.min(low, system.getOwnState()[1]);
            high = Math.max(high, system.getOwnState()[1]);
        }
    }

    /**
     * 20 s, about 140 impacts; sideways nothing acts. Measured: never beyond the planes by more than round-off. The
     * impacts conserve the energy of 29.45 J. A method of order 1 is off by (g deltaT)&sup2;/2 at each of 600 steps, as
     * without impacts: euler gains 32.08 J, and the other two lose energy until the ball slides along the floor at 0.3
     * m/s.
     */
    @ParameterizedTest
    @MethodSource("deSolvers.catalog.SolverCatalog#names")
    void withClampItStaysBetweenFloorAndCeiling(String solver) {
        Scene scene = scene(SLOT.formatted("clamp", "1"), solver, 1.0 / 30, 20);
        Range range = new Range();
        scene.simulation().addObserver(range);
        scene.simulation().run();
        assertTrue(range.low >= -1e-15 && range.high <= 1 + 1e-15, range.low + " ... " + range.high);
        assertEquals(6, scene.system().getOwnState()[0], 1e-12);
        double error = 600 * Math.pow(9.81 / 30, 2) / 2;
        double expected = switch (solver) {
            case "euler" -> 29.45 + error;
            case "symplectic-euler", "backward-euler", "linearised-euler" -> 0.045;
            default -> 29.45;
        };
        assertEquals(expected, scene.system().getEnergy(scene.system().getOwnState(), 20), 4e-12,
                "measured: 4.3e-13 at most");
    }

    /** A slot of 1 mm: at 7 m/s a step of 1/30 s would cross it 230 times. */
    @ParameterizedTest
    @MethodSource("deSolvers.catalog.SolverCatalog#names")
    void aSlotMuchNarrowerThanAStepDoesNotLetItOut(String solver) {
        ParticleSystem system = run(SLOT.formatted("clamp", "0.501"), solver, 1.0 / 30, 5);
        double y = system.getOwnState()[1];
        assertTrue(y >= -1e-12 && y <= 0.501 + 1e-12, "y = " + y);
    }

    /** With exact impacts the energy error is the method's: 0 for a parabola from order 2 on. */
    @ParameterizedTest
    @MethodSource("deSolvers.catalog.SolverCatalog#names")
    void exactImpactsConserveEnergy(String solver) {
        Scene scene = scene(SLOT.formatted("exact", "1"), solver, 1.0 / 30, 5);
        double start = scene.system().getEnergy(scene.system().getOwnState(), 0);
        scene.simulation().run();
        double y = scene.system().getOwnState()[1];
        assertTrue(y >= -1e-9 && y <= 1 + 1e-9, "y = " + y);
        boolean firstOrder = SolverCatalog.info(solver).order() == 1;
        double energy = scene.system().getEnergy(scene.system().getOwnState(), 5);
        assertEquals(0, energy / start - 1, firstOrder ? 0.9 : 1e-9);
        assertAbove(25, scene.simulation().getEvents());
    }

    /**
     * With clamp it comes to rest at the bottom, held by both planes. Not with euler, which keeps hitting the planes
     * with the speed gained in two steps, 2 g h (measured 0.97 of that), within 0.1 mm of the bottom.
     */
    @ParameterizedTest
    @MethodSource("deSolvers.catalog.SolverCatalog#names")
    void withClampItComesToRestInTheGroove(String solver) {
        ParticleSystem system = run(GROOVE.formatted("clamp"), solver, 1.0 / 512, 12);
        boolean euler = solver.equals("euler");
        assertEquals(0, system.getOwnState()[0], euler ? 1e-4 : 1e-15);
        assertEquals(0, system.getOwnState()[1], euler ? 1e-4 : 1e-15);
        assertEquals(0, fastest(system), euler ? 2 * 9.81 / 512 : 0);
    }
}
