package particles.effects;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Systems.GRAVITY;
import static particles.Systems.entry;
import static particles.Systems.oneParticle;
import static particles.Systems.run;

import deSolvers.RK4Solver;
import deSolvers.symplectic.Yoshida4Solver;
import org.junit.jupiter.api.Test;
import particles.ParticleSystem;
import particles.law.Plane;
import particles.law.SeededRandom;
import particles.law.Sphere;
import particles.law.Vector3;

/** Drag, orbits, penalties and cohesion against their closed forms. */
class ForceLawsTest {

    /**
     * v = v_t tanh(g t/v_t), fall = v_t&sup2;/g ln cosh(g t/v_t), v_t = sqrt(m g/c). Measured with rk4 at 0.01: 7e-9.
     */
    @Test
    void fallWithQuadraticDragMeetsTheClosedForm() {
        double c = 0.3;
        double terminal = Math.sqrt(9.81 / c);
        ParticleSystem system = oneParticle(Vector3.ZERO, Vector3.ZERO);
        system.addEffect(new Gravity(system.getParticles(), GRAVITY));
        system.addEffect(new QuadraticDrag(system.getParticles(), c, Wind.STILL));
        run(system, new RK4Solver(), 0.01, 1);
        assertEquals(-terminal * Math.tanh(9.81 / terminal), entry(system, 4), 2e-8);
        assertEquals(-terminal * terminal / 9.81 * Math.log(Math.cosh(9.81 / terminal)), entry(system, 1), 2e-8);
        run(system, new RK4Solver(), 0.01, 20);
        assertEquals(-terminal, entry(system, 4), 1e-12, "terminal speed");
    }

    /** A particle ends up moving with a steady wind: v - u = 1/(c t + 1/w0). Measured: 2e-11. */
    @Test
    void windCarriesParticlesByQuadraticDrag() {
        ParticleSystem system = oneParticle(Vector3.ZERO, Vector3.ZERO);
        system.addEffect(new QuadraticDrag(system.getParticles(), 0.5, new GustyWind(new Vector3(3, 4, 0), Vector3.ZERO,
                1)));
        run(system, new RK4Solver(), 0.01, 2);
        double left = 1 / (0.5 * 2 + 1.0 / 5);
        assertEquals(3 - 0.6 * left, entry(system, 3), 1e-9);
        assertEquals(4 - 0.8 * left, entry(system, 4), 1e-9);
    }

    /**
     * Kepler: from perihelion a (1 - e), after half a period pi sqrt(a&sup3;/mu) at aphelion -a (1 + e), after a whole
     * one back. Measured with yoshida4 at T/2000: 3e-7, 2e-9.
     */
    @Test
    void orbitsAreKeplerEllipses() {
        double mu = 2;
        double a = 1.5;
        double e = 0.5;
        double period = 2 * Math.PI * Math.sqrt(a * a * a / mu);
        ParticleSystem system = oneParticle(new Vector3(a * (1 - e), 0, 0),
                new Vector3(0, Math.sqrt(mu / a * (1 + e) / (1 - e)), 0));
        system.addEffect(new PointAttraction(system.getParticles(), Vector3.ZERO, mu, 0));
        double energy = system.getEnergy(system.getOwnState(), 0);
        assertEquals(-mu / (2 * a), energy, 1e-15);
        run(system, new Yoshida4Solver(), period / 2000, period / 2);
        assertEquals(-a * (1 + e), entry(system, 0), 1e-6);
        assertEquals(0, entry(system, 1), 1e-6);
        run(system, new Yoshida4Solver(), period / 2000, period / 2);
        assertEquals(a * (1 - e), entry(system, 0), 1e-6);
        assertEquals(energy, system.getEnergy(system.getOwnState(), 0), 1e-8);
    }

    /** With softening, a small oscillation through the centre has omega&sup2; = mu/s&sup3;. */
    @Test
    void softeningLetsParticlesPassThroughTheCentre() {
        double s = 0.5;
        double mu = 2;
        ParticleSystem system = oneParticle(new Vector3(1e-4, 0, 0), Vector3.ZERO);
        system.addEffect(new PointAttraction(system.getParticles(), Vector3.ZERO, mu, s));
        double period = 2 * Math.PI / Math.sqrt(mu / (s * s * s));
        run(system, new RK4Solver(), period / 500, period / 2);
        assertEquals(-1e-4, entry(system, 0), 1e-10);
    }

    /**
     * Without loss a particle is inside for pi sqrt(m/k) and leaves as fast as it came: on a plane, a ball and in a
     * hollow.
     */
    @Test
    void aPenaltyWithoutLossReturnsAllEnergy() {
        double k = 1e4;
        double inside = Math.PI / Math.sqrt(k);
        ParticleSystem plane = oneParticle(Vector3.ZERO, new Vector3(3, -2, 0));
        plane.addEffect(new Penalty(plane.getParticles(), Plane.ground(0), k, 0));
        run(plane, new RK4Solver(), inside / 300, inside);
        assertEquals(0, entry(plane, 1), 1e-9);
        assertEquals(2, entry(plane, 4), 1e-8);
        assertEquals(3, entry(plane, 3));
        for (boolean hollow : new boolean[] {false, true}) {
            ParticleSystem ball = oneParticle(new Vector3(5, 1, 1), new Vector3(hollow ? 2 : -2, 0, 0));
            ball.addEffect(new Penalty(ball.getParticles(), new Sphere(new Vector3(4, 1, 1), 1, hollow), k, 0));
            run(ball, new RK4Solver(), inside / 300, inside);
            assertEquals(5, entry(ball, 0), 1e-9);
            assertEquals(hollow ? -2 : 2, entry(ball, 3), 1e-8);
        }
    }

    /**
     * With loss b, from m v dv/(1 - b v) = k d dd: it comes in with v0 and leaves with w where
     * b (v0 + w) = ln((1 + b v0)/(1 - b w)). Measured: 1e-7 of v0 (the end of contact lies within a step).
     */
    @Test
    void bounceLossGivesTheRestitutionOfItsClosedForm() {
        double b = 0.4;
        double v0 = 2;
        ParticleSystem system = oneParticle(new Vector3(0, 0, 0), new Vector3(0, -v0, 0));
        system.addEffect(new Penalty(system.getParticles(), Plane.ground(0), 1e4, b));
        run(system, new RK4Solver(), 2e-5, 0.1);
        double w = entry(system, 4);
        assertTrue(w > 0.8 && w < 1.9, "leaves with " + w);
        assertEquals(Math.log((1 + b * v0) / (1 - b * w)), b * (v0 + w), 1e-6);
    }

    /**
     * Two particles oscillate about the distance of balance with omega&sup2; = 2 e (dX/dr)&sup2;/(m/2). Measured: 2e-8
     * of the amplitude.
     */
    @Test
    void aCohesivePairOscillatesAboutItsDistanceOfBalance() {
        double h = 1;
        double d = 0.6;
        double e = 0.5;
        double swing = 1e-6;
        ParticleSystem system = new ParticleSystem();
        system.addParticle("a", 1, Vector3.ZERO, Vector3.ZERO, false);
        system.addParticle("b", 1, new Vector3(d + swing, 0, 0), Vector3.ZERO, false);
        system.addEffect(new Cohesion(system.getParticles(), h, d, e, 0));
        assertEquals(-e, system.getEnergy(system.getOwnState(), 0), 1e-10);
        double slope = 8 * d / (h * h * (1 - d * d));
        double omega = Math.sqrt(2 * e * slope * slope / 0.5);
        run(system, new RK4Solver(), 0.001 / omega, Math.PI / omega);
        assertEquals(d - swing, entry(system, 6) - entry(system, 0), 1e-4 * swing);
    }

    /** The grid finds the same pairs as a loop over all of them, also across the origin and far away. */
    @Test
    void theGridFindsEveryNeighbourOnce() {
        SeededRandom random = new SeededRandom(3);
        for (double far : new double[] {0, 1e6}) {
            ParticleSystem system = new ParticleSystem();
            for (int i = 0; i < 300; i++) {
                system.addParticle("p" + i, 1, new Vector3(far + 4 * random.nextDouble() - 2,
                        4 * random.nextDouble() - 2,
                        4 * random.nextDouble() - 2), Vector3.ZERO, false);
            }
            Cohesion fast = new Cohesion(system.getParticles(), 0.7, 0.4, 1, 0);
            double pairs = 0;
            double[] state = system.getOwnState();
            for (int i = 0; i < 300; i++) {
                for (int j = 0; j < i; j++) {
                    ParticleSystem two = new ParticleSystem();
                    for (int p : new int[] {i, j}) {
                        two.addParticle("p", 1, new Vector3(state[6 * p], state[6 * p + 1], state[6 * p + 2]),
                                Vector3.ZERO, false);
                    }
                    pairs += new Cohesion(two.getParticles(), 0.7, 0.4, 1, 0).getPotentialEnergy(two.getOwnState(), 0);
                }
            }
            assertTrue(Math.abs(pairs) > 10);
            assertEquals(pairs, fast.getPotentialEnergy(state, 0), 1e-10 * Math.abs(pairs));
        }
    }

    /** Eight times as many particles at the same density give eight times as many candidate pairs: measured 8.4. */
    @Test
    void workGrowsWithTheNumberOfParticles() {
        double ratio = pairsToLookAt(8000) / (double) pairsToLookAt(1000);
        assertTrue(ratio < 9.5, "ratio " + ratio);
        assertTrue(pairsToLookAt(1000) < 1000 * 999 / 2 / 5, "far fewer than all pairs");
    }

    private static long pairsToLookAt(int count) {
        SeededRandom random = new SeededRandom(8);
        double width = Math.cbrt(count);
        double[] state = new double[6 * count];
        for (int k = 0; k < state.length; k++) {
            state[k] = width * random.nextDouble();
        }
        NeighbourGrid grid = new NeighbourGrid();
        grid.build(state, count, 1.2);
        long pairs = 0;
        int[] found = new int[count];
        for (int i = 0; i < count; i++) {
            pairs += grid.findLater(i, found);
        }
        return pairs;
    }

    /**
     * A flying cube of 64 particles becomes a round drop: no particle leaves, the corners move in, momentum is
     * conserved.
     */
    @Test
    void aDropHoldsTogether() {
        ParticleSystem system = new ParticleSystem();
        for (int i = 0; i < 64; i++) {
            Vector3 at = new Vector3(i % 4 - 1.5, i / 4 % 4 - 1.5, i / 16 - 1.5).times(0.19);
            system.addParticle("p" + i, 0.01, at, new Vector3(2, 0, 0), false);
        }
        system.addEffect(new Cohesion(system.getParticles(), 0.3, 0.18, 0.01, 0.05));
        double corner = farthest(system);
        run(system, new RK4Solver(), 0.004, 3);
        assertTrue(farthest(system) < 0.9 * corner, "from " + corner + " to " + farthest(system));
        assertTrue(farthest(system) > 0.25, "and it does not collapse: " + farthest(system));
        double momentum = 0;
        for (int i = 0; i < 64; i++) {
            momentum += 0.01 * entry(system, 6 * i + 3);
        }
        assertEquals(1.28, momentum, 1e-13);
    }

    private static double farthest(ParticleSystem system) {
        double centre = 0;
        int n = system.getParticles().count();
        for (int i = 0; i < n; i++) {
            centre += entry(system, 6 * i) / n;
        }
        double farthest = 0;
        for (int i = 0; i < n; i++) {
            farthest = Math.max(farthest, Math.hypot(entry(system, 6 * i) - centre,
                    Math.hypot(entry(system, 6 * i + 1), entry(system, 6 * i + 2))));
        }
        return farthest;
    }
}
