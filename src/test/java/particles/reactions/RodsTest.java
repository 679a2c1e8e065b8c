package particles.reactions;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Systems.afterStep;
import static particles.reactions.Pendulums.chain;
import static particles.reactions.Pendulums.constraints;
import static particles.reactions.Pendulums.distance;
import static particles.reactions.Pendulums.worstLength;

import deSolvers.DESolver;
import deSolvers.RK4Solver;
import deSolvers.catalog.SolverCatalog;
import deSolvers.problems.Steps;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import particles.ParticleSystem;
import particles.Simulation;
import particles.law.Vector3;
import particles.rules.ConstraintProjection;
import particles.scene.ShortRun;

/** Rods against closed forms: their forces, the errors of their lengths, and the order of solvers. */
class RodsTest {
    private static final double G = 9.81;

    /** Bound: 1e-6 with feedback alone, over 10 minutes. Measured: 1.0e-7 for one rod, 8.3e-8 for two. */
    @ParameterizedTest
    @CsvSource({"1, 90", "2, 60"})
    void feedbackAloneKeepsLengthsForTenMinutes(int rods, double degrees) {
        ParticleSystem system = chain(rods, degrees, 5);
        double worst = worstLength(system, new RK4Solver(), 0.01, 60_000);
        assertTrue(worst <= 5e-7, "length off by " + worst);
        ParticleSystem without = chain(rods, degrees, 0);
        assertTrue(worstLength(without, new RK4Solver(), 0.01, 60_000) > 0.01, "without feedback the errors add up");
    }

    /** Bound: 1e-12 with projection. Measured: 4e-16. */
    @Tag("slow")
    @ParameterizedTest
    @CsvSource({"1, 90", "2, 60"})
    void projectionKeepsLengthsToRounding(int rods, double degrees) {
        ParticleSystem system = chain(rods, degrees, 5);
        Simulation simulation = new Simulation(system, RK4Solver::new, 0.01, 600);
        simulation.addRule(new ConstraintProjection(constraints(system)));
        double[] worst = {0};
        simulation.addRule(afterStep(s -> {
            worst[0] = Math.max(worst[0], Pendulums.lengthError(s));
            return false;
        }));
        simulation.run();
        assertEquals(60_000, simulation.getSteps());
        assertTrue(worst[0] <= 4e-15, "length off by " + worst[0]);
    }

    /**
     * The period over that of small swings is 1/AGM(1, cos(a/2)); by rk4 at 0.0025 s. Measured: 2.5e-8, at 170 degrees.
     */
    @ParameterizedTest
    @CsvSource({"10, 1.001907188143217", "45, 1.039973343196804", "90, 1.180340599016096", "120, 1.372880500618350",
        "170, 2.439362719673885"})
    void pendulumPeriodsFollowTheArithmeticGeometricMean(double degrees, double ratio) {
        ParticleSystem system = chain(1, degrees, 5);
        double period = 2 * Math.PI / Math.sqrt(G) * ratio;
        double h = 0.0025;
        DESolver solver = new RK4Solver();
        double before = 0;
        int crossings = 0;
        for (int k = 0; crossings < 4; k++) {
            solver.stepState(system, h);
            double x = system.getOwnState()[6];
            if (k > 0 && x * before < 0 && ++crossings == 4) {
                Pendulums.refine(system, 0, h);
            }
            before = x;
        }
        assertEquals(1.75 * period, system.getTime(), 1e-7 * period, "the fourth passage comes after 7/4 of a period");
    }

    /** Released or passing, at an angle a: the rod carries m (g cos a + v&sup2;/l); it adds no power. */
    @Test
    void aRodCarriesWeightAndCentripetalForce() {
        ParticleSystem system = chain(1, 35, 5);
        double a = Math.toRadians(35);
        double v = 1.7;
        double[] state = system.getOwnState();
        state[9] = v * Math.cos(a);
        state[10] = v * Math.sin(a);
        double[] force = new double[12];
        system.addUpEffects(state, 0, force);
        assertEquals(0, constraints(system).getPower(state, 0, force), 1e-14);
        constraints(system).addForces(state, 0, force);
        double tension = G * Math.cos(a) + v * v;
        assertEquals(-tension * Math.sin(a), force[9], 1e-14);
        assertEquals(tension * Math.cos(a) - G, force[10], 1e-14);
    }

    /** Rod k of a hanging chain carries all that is below it. Measured: 3e-12 of 981 N. */
    @Test
    void aHangingChainCarriesItsWeight() {
        int n = 100;
        ParticleSystem system = chain(n, 0, 5);
        double[] force = new double[6 * (n + 1)];
        system.addUpEffects(system.getOwnState(), 0, force);
        constraints(system).addForces(system.getOwnState(), 0, force);
        assertEquals(-(n + 1) * G, force[4], 3e-11, "at the hook, including its own weight");
        for (int i = 1; i <= n; i++) {
            assertEquals(0, force[6 * i + 4], 3e-11, "no net force on " + i);
        }
    }

    /** 100 rods that fall from level for three seconds keep lengths and energy. Measured: 3e-10 m, 2e-6 of 49,000 J. */
    @Test
    void aLongSwingingChainKeepsLengthsAndEnergy() {
        ParticleSystem system = chain(100, 90, 5);
        double before = system.getEnergy(system.getOwnState(), 0);
        double worst = worstLength(system, new RK4Solver(), 0.002, 1500);
        assertTrue(worst < 3e-9, "length off by " + worst);
        assertEquals(before, system.getEnergy(system.getOwnState(), 0), 2e-5);
    }

    private static double difference(double[] a, double[] b) {
        double largest = 0;
        for (int k = 0; k < a.length; k++) {
            largest = Math.max(largest, Math.abs(a[k] - b[k]));
        }
        return largest;
    }

    /** A square with both diagonals has a redundant rod. */
    private static ShortRun square(String steps, String corners, String effects) {
        return ShortRun.of("rk4 clamp " + steps, """
                particles: [%s]
                effects: [%s]
                rods: [{from: c0, to: c1}, {from: c0, to: c2}, {from: c0, to: c3}, {from: c1, to: c2},
                       {from: c1, to: c3}, {from: c2, to: c3}]
                """.formatted(corners, effects));
    }

    /** The square rotates rigidly all the same. */
    @Test
    void redundantRodsShareTheLoad() {
        ShortRun run = square("0.01 1", """
                {id: c0, position: [1, 0, 0], velocity: [0, 1, 0]}, {id: c1, position: [0, 1, 0], velocity: [-1, 0, 0]},
                {id: c2, position: [-1, 0, 0], velocity: [0, -1, 0]}, {id: c3, position: [0, -1, 0],
                velocity: [1, 0, 0]}""", "");
        for (int i = 0; i < 4; i++) {
            double a = Math.PI / 2 * i + 1;
            assertEquals(Math.cos(a), run.at(6 * i), 4e-8, "rk4's phase; measured 7e-9");
            assertEquals(Math.sin(a), run.at(6 * i + 1), 4e-8);
        }
    }

    /** The same square falls, tilted: its rods carry nothing but round-off. */
    @Test
    void redundantRodsFallWithoutLoad() {
        ShortRun run = square("0.005 1", """
                {id: c0, position: [0.1, 0.3, 0]}, {id: c1, position: [1.0553, 0.5955, 0]},
                {id: c2, position: [0.7598, 1.5508, 0]}, {id: c3, position: [-0.1955, 1.2553, 0]}""", "gravity");
        double[][] corners = {{0.1, 0.3}, {1.0553, 0.5955}, {0.7598, 1.5508}, {-0.1955, 1.2553}};
        for (int i = 0; i < 4; i++) {
            assertEquals(corners[i][0], run.at(6 * i), 1e-15, "measured: 0");
            assertEquals(corners[i][1] - G / 2, run.at(6 * i + 1), 1.7e-13, "measured: 1.8e-14");
        }
    }

    @Test
    void rodsFollowWhenParticlesAreRemoved() {
        ParticleSystem system = chain(3, 90, 5);
        system.removeParticles(new boolean[] {false, true, false, false});
        assertEquals(1, constraints(system).springCount());
        assertEquals(1, constraints(system).from(0));
        assertEquals(2, constraints(system).to(0));
        worstLength(system, new RK4Solver(), 0.01, 100);
        assertEquals(1, distance(system, 1, 2), 1e-12, "falls as a whole");
        system.removeParticles(new boolean[] {false, true, true});
        assertFalse(constraints(system).isActive());
    }

    @Test
    void invalidRodsAreRefused() {
        ParticleSystem system = chain(1, 0, 5);
        system.addParticle("nail", 1, new Vector3(1, 1, 1), Vector3.ZERO, true);
        Steps.assertRefused(() -> constraints(system).addRod(0, 2, 1), () -> constraints(system).addRod(1, 1, 1),
                () -> constraints(system).addRod(0, 1, 0), () -> new RigidConstraints(system, -1));
    }

    /**
     * Half a second of a double pendulum with every solver at 0.0025 s; the table has the bound and the measured error.
     */
    @ParameterizedTest
    @CsvSource({"euler, 0.05, 1.5e-2", "midpoint, 4e-4, 8e-5", "step-doubling, 8e-9, 1.6e-9",
            "dormand-prince, 8e-9, 1.6e-9",
        "bulirsch-stoer, 8e-9, 1.8e-9", "adams, 2e-8, 6e-9", "symplectic-euler, 0.02, 5e-3", "verlet, 2e-4, 4e-5",
        "yoshida4, 8e-8, 1.6e-8", "backward-euler, 0.05, 1.5e-2", "implicit-midpoint, 2e-4, 4e-5",
        "radau, 8e-9, 1.6e-9"})
    void everySolverHandlesRods(String name, double bound, double measured) {
        ParticleSystem expected = chain(2, 60, 5);
        worstLength(expected, new RK4Solver(), 0.0025, 200);
        ParticleSystem system = chain(2, 60, 5);
        worstLength(system, SolverCatalog.create(name), 0.0025, 200);
        double error = difference(expected.getStateArray(), system.getStateArray());
        assertTrue(error <= bound && error > measured / 10, name + ": " + error);
    }

    /**
     * The rod's force grows with v&sup2;, so symplectic methods are none here: their energy drifts without end.
     * Measured as a part of the energy, after this time and twice as long.
     */
    @ParameterizedTest
    @CsvSource({"symplectic-euler, 0.005, 20, 0.2034, 0.5206", "verlet, 0.005, 100, -0.00255, -0.00513",
        "yoshida4, 0.01, 100, 5.04e-4, 0.001007"})
    void onARodSymplecticMethodsDrift(String solver, double deltaT, double time, double once, double twice) {
        for (int k = 1; k <= 2; k++) {
            double part = ShortRun.of(solver + " clamp " + deltaT + " " + k * time, """
                    particles: [{id: nail, position: [0, 0, 0], fixed: true}, {id: bob, position: [0.8660254, -0.5, 0]}]
                    rods: [{from: nail, to: bob}]
                    """).getNumericalError() / (0.5 * G);
            assertEquals(1, part / (k == 1 ? once : twice), 0.01);
        }
    }
}
