package particles.rules;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.scene.ShortRun.G;

import deSolvers.catalog.SolverCatalog;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import particles.scene.ShortRun;

/** Coulomb friction with clamped impacts, by every solver: closed forms, and bodies of many particles. */
class FrictionOfEverySolverTest {
    /** A block on a slope of 0.75, so that sin a = 0.6. */
    private static final String BLOCK = """
            particles:
              - {id: block, position: [0, 0, 0], mass: 2, velocity: %s}
            rules:
              - plane: {normal: [0.6, 0.8, 0], restitution: 0, friction: {law: coulomb, coefficient: %s, static: %s}}
            """;

    /** The block's coordinates are x' downhill and z sideways. */
    private static double[] slide(String steps, double mu, double held, String velocity) {
        ShortRun run = ShortRun.of(steps, BLOCK.formatted(velocity, mu, held));
        assertEquals(0, 0.6 * run.at(0) + 0.8 * run.at(1), 1e-9, "on the plane");
        return new double[] {0.8 * run.at(0) - 0.6 * run.at(1), run.at(2), 0.8 * run.at(3) - 0.6 * run.at(4),
            run.at(5), run.getNumericalError()};
    }

    @ParameterizedTest
    @MethodSource("deSolvers.catalog.SolverCatalog#names")
    void aBlockSlidesOnlyIfTheSlopeIsSteeperThanStaticFriction(String solver) {
        double[] held = slide(solver + " clamp 0.01 1", 0.5, 0.76, "[0, 0, 0]");
        assertEquals(0, held[0], 0, "0.75 is less than 0.76");
        for (double mu : new double[] {0.5, 0.74}) {
            double[] slid = slide(solver + " clamp 0.01 1", mu, 0.74, "[0, 0, 0]");
            double a = G * (0.6 - mu * 0.8);
            assertEquals(a, slid[2], 1e-10);            // a constant force: each method is exact for the velocity
            assertEquals(a / 2, slid[0], SolverCatalog.info(solver).order() == 1 ? a * 0.01 : 1e-10);
        }
    }

    /** Thrown uphill and sideways with 2 m/s on a plane with mu = 1, where it stops; the path is curved. */
    @ParameterizedTest
    @MethodSource("deSolvers.catalog.SolverCatalog#names")
    void aCurvedSlideEndsWhereTheExactOneDoes(String solver) {
        double[] exact = slide("rk4 exact 0.001 1.5", 1, 1, "[-0.8, 0.6, 2]");
        assertEquals(0, Math.hypot(exact[2], exact[3]), 0, "it has stopped");
        for (double deltaT : new double[] {0.02, 0.01, 0.005}) {
            double[] end = slide(solver + " clamp " + deltaT + " 1.5", 1, 1, "[-0.8, 0.6, 2]");
            double error = Math.hypot(end[0] - exact[0], end[1] - exact[1]);
            assertEquals(0, Math.hypot(end[2], end[3]), 0, "it has stopped");
            assertTrue(error <= 3 * deltaT, error + " m with steps of " + deltaT + " s");      // at most 1.5 measured
            assertEquals(0, end[4], mostError(solver) * deltaT, "numerical error (J) of an energy of 5 J");
        }
    }

    /**
     * Methods of order 1 gain or lose with friction or without, here 24 W times deltaT; of all others at most 0.46 is
     * measured, where the force of friction has a kink in the step of the stop.
     */
    private static double mostError(String solver) {
        return SolverCatalog.info(solver).order() == 1 ? 30 : 1;
    }

    /** A rope that falls over a rough ball: springs press each particle now more, now less, and turn it round often. */
    private static final String ROPE = """
            shapes:
              - rope: {id: rope, start: [-0.6, 0.55, 0.02], end: [0.7, 0.55, 0.02], particles: 12, totalMass: 0.2,
                       structural: {stiffness: 200, damping: 0.1}}
            rules:
              - sphere: {centre: [0, 0, 0], radius: 0.5, restitution: 0,
                        friction: {law: coulomb, coefficient: 0.4, impacts: false}}
            """;

    /**
     * Euler's rope blows up with friction and without. Of the others all of order 3 and more agree in what friction
     * takes, 0.07626 J within 4e-5 J; with exact impacts and short steps it is 0.07617 J. Those of order 2 are within
     * 0.0025 J, and symplectic Euler too.
     */
    @ParameterizedTest
    @MethodSource("deSolvers.catalog.SolverCatalog#names")
    void frictionOnARopeStopsNoSolver(String solver) {
        if (solver.equals("euler")) {
            return;
        }
        ShortRun run = ShortRun.of(solver + " clamp 0.002 0.8", ROPE);
        assertEquals(0.8, run.getSystem().getTime(), 1e-12);
        if (SolverCatalog.info(solver).order() >= 3) {
            assertEquals(-0.07626, run.work("contact"), 1e-4);
            assertEquals(0, run.getNumericalError(), 2e-4);          // measured: 0.75e-4 by yoshida4
        } else if (!solver.equals("backward-euler") && !solver.equals("linearised-euler")) {
            // these two damp the motion itself: backward Euler by 0.064 J
            assertEquals(-0.07617, run.work("contact"), 0.005);
            assertEquals(0, run.getNumericalError(), 0.01);          // measured: 0.0033 by midpoint
        }
    }

    /**
     * A gust 6 sin(pi t/2) m/s blows a leaf at the origin out of static friction, which it passes with a force of 0:
     * c u(t) = mu m g where sin(pi t/2) = 0.4905, at t = 0.3264 s. No velocity of more than round-off shows which way.
     */
    @ParameterizedTest
    @MethodSource("deSolvers.catalog.SolverCatalog#names")
    void aSlideBeginsWhereTheForceOutgrowsFriction(String solver) {
        for (String impact : List.of("clamp", "exact")) {
            double held = ShortRun.of(solver + " " + impact + " 0.01 0.32", GUST).at(3);
            assertEquals(0, held, "it is held");
            double speed = ShortRun.of(solver + " " + impact + " 0.01 0.4", GUST).at(3);
            // v' = 6 sin(pi t/2) - v - 0.3 g, in a series up to (t - t_0)^3; methods of order 1 are off by 0.0026 m/s,
            // and clamped the slide begins up to 0.01 s late
            double bound = SolverCatalog.info(solver).order() == 1 ? 0.004 : 0.002;
            assertEquals(0.0212, speed, impact.equals("exact") ? bound : 0.006, impact);
        }
    }

    private static final String GUST = """
            particles: [{id: leaf, position: [0, 0, 0], mass: 0.01}]
            effects: [gravity, drag: {coefficient: 0.01}, wind: {mean: [0, 0, 0], gust: [6, 0, 0], period: 4}]
            rules: [ground: {restitution: 0, friction: {law: coulomb, coefficient: 0.3}}]
            """;
}
