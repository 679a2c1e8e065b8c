package particles.effects;

import static deSolvers.problems.Bounds.assertBelow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.DESolver;
import deSolvers.adaptive.DormandPrinceSolver;
import deSolvers.catalog.SolverCatalog;
import org.junit.jupiter.api.Test;
import particles.ParticleSystem;
import particles.Systems;
import particles.law.Vector3;

/** A charge in a magnetic field, against circles, helices and the motion of guiding centres. */
class MagneticFieldTest {
    private static final double UNIFORM = Double.POSITIVE_INFINITY;

    private static ParticleSystem charged(double charge, Vector3 field, double length, Vector3 place, Vector3 v) {
        ParticleSystem system = Systems.oneParticle(place, v);
        system.addEffect(new MagneticField(system.getParticles(), charge, field, Vector3.ZERO, length));
        return system;
    }

    /** omega = q B/m whatever the speed; v along the field stays. A positive charge goes round clockwise. */
    @Test
    void aChargeGoesRoundOnAHelix() {
        double omega = 2 * 1.5;
        ParticleSystem system = charged(2, new Vector3(0, 0, 1.5), UNIFORM, Vector3.ZERO, new Vector3(3, 0, 0.7));
        double time = 2.3;
        new DormandPrinceSolver(1e-13, 1e-13).stepState(system, time);
        double[] state = system.getOwnState();
        double radius = 3 / omega;
        assertEquals(radius * Math.sin(omega * time), state[0], 1e-12);
        assertEquals(radius * (Math.cos(omega * time) - 1), state[1], 1e-12);
        assertEquals(0.7 * time, state[2], 1e-12);
    }

    private static double growth(String solver, double deltaT, int steps) {
        ParticleSystem system = charged(1, new Vector3(0, 0, 1), UNIFORM, Vector3.ZERO, new Vector3(1, 0, 0));
        DESolver made = SolverCatalog.create(solver);
        for (int step = 0; step < steps; step++) {
            made.stepState(system, deltaT);
        }
        return Math.hypot(system.getOwnState()[3], system.getOwnState()[4]);
    }

    /**
     * The closing half kick of verlet is implicit: a Cayley transform, which keeps the speed with any deltaT for which
     * its fixed point is found. That of yoshida4 are three of them. The explicit kick of symplectic Euler, and Euler's
     * step, let it grow.
     */
    @Test
    void someSolversKeepTheSpeed() {
        // measured 9e-12: the fixed point ends at 1e-13 of the speed in each half kick
        assertEquals(1, growth("verlet", 0.5, 1000), 1e-10);
        assertEquals(1, growth("yoshida4", 0.3, 1000), 1e-10);
        assertEquals(1, growth("implicit-midpoint", 0.5, 1000), 1e-10);
        double grown = Math.pow(1 + 0.01, 50);
        assertEquals(grown, growth("symplectic-euler", 0.1, 100), 1e-12 * grown);
        assertEquals(grown, growth("euler", 0.1, 100), 1e-12 * grown);
    }

    @Test
    void everySolverHasItsOrderInABottle() {
        Systems.assertOrders(() -> charged(1, new Vector3(0, 1, 2), 1.5, new Vector3(0.2, 0, 0.3),
                new Vector3(0.5, 0.2, 1)), 2, 512, 0.2);
    }

    /**
     * A guiding centre near the axis keeps v_across^2/B, so v_along^2 = v^2 - v_across0^2 (1 + z^2/L^2): it swings as
     * L (v_along0/v_across0) sin(v_across0 t/L), whatever charge and field are, as long as the circles are small.
     */
    @Test
    void aBottleTurnsAChargeBack() {
        double length = 2;
        double across = 1;
        double along = 0.6;
        double field = 200;
        ParticleSystem system = charged(1, new Vector3(0, 0, field), length, new Vector3(across / field, 0, 0),
                new Vector3(0, -across, along));
        DESolver solver = new DormandPrinceSolver(1e-11, 1e-12);
        double quarter = Math.PI / 2 * length / across;
        solver.stepState(system, quarter);
        assertEquals(length * along / across, system.getOwnState()[2], 2e-5);         // measured 1.6e-6
        solver.stepState(system, quarter);
        assertEquals(0, system.getOwnState()[2], 1e-2);
        assertTrue(system.getOwnState()[5] < 0, "it flies back");
        double speed = Vector3.at(system.getOwnState(), 3).length();
        assertBelow(1e-8, Math.abs(speed - Math.hypot(across, along)));
    }

    /** A field without curl and divergence: its gradient is symmetric and has no trace. */
    @Test
    void theFieldOfABottleHasNeitherDivergenceNorCurl() {
        Vector3 at = new Vector3(0.4, -0.3, 0.9);
        double h = 1e-5;
        double[][] slope = new double[3][];
        for (int b = 0; b < 3; b++) {
            Vector3 step = new Vector3(b == 0 ? h : 0, b == 1 ? h : 0, b == 2 ? h : 0);
            Vector3 change = field(at.plus(step)).minus(field(at.minus(step))).times(0.5 / h);
            slope[b] = new double[] {change.x(), change.y(), change.z()};
        }
        assertBelow(2e-10, Math.abs(slope[0][0] + slope[1][1] + slope[2][2]));
        assertEquals(slope[0][1], slope[1][0], 2e-10);
        assertEquals(slope[0][2], slope[2][0], 2e-10);
        assertEquals(slope[1][2], slope[2][1], 2e-10);
        assertTrue(Math.abs(slope[0][1]) > 0.1);
    }

    /** B, from the forces on velocities along x and y. */
    private static Vector3 field(Vector3 at) {
        Vector3 onX = force(at, new Vector3(1, 0, 0));
        Vector3 onY = force(at, new Vector3(0, 1, 0));
        return new Vector3(-onY.z(), onX.z(), -onX.y());
    }

    private static Vector3 force(Vector3 at, Vector3 v) {
        ParticleSystem system = charged(1, new Vector3(1, 2, -1), 1.5, at, v);
        double[] dSdt = new double[6];
        system.getStateDerivative(dSdt);
        return Vector3.at(dSdt, 3);
    }
}
