package particles.effects;

import static deSolvers.problems.Bounds.assertAbove;
import static deSolvers.problems.Bounds.assertBelow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import particles.ParticleSystem;
import particles.effects.neighbours.NeighbourGrid;
import particles.law.SeededRandom;
import particles.law.Vector3;
import particles.scene.ShortRun;

/** Cohesion among many particles: its grid of neighbours, and a drop. */
class CohesionTest {

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
        assertBelow(9.5, ratio);
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
        ShortRun start = drop(0);
        ShortRun run = drop(3);
        assertBelow(0.9 * farthest(start), farthest(run));
        assertAbove(0.25, farthest(run), "and it does not collapse");
        double momentum = 0;
        for (int i = 0; i < 64; i++) {
            momentum += 0.01 * run.at(6 * i + 3);
        }
        assertEquals(1.28, momentum, 1e-13);
    }

    private static ShortRun drop(double duration) {
        return ShortRun.of("rk4 clamp 0.004 " + duration, """
                shapes:
                  - jelly: {centre: [0, 0, 0], size: [0.57, 0.57, 0.57], columns: 4, rows: 4, layers: 4, mass: 0.01,
                            velocity: [2, 0, 0], surface: false}
                effects: [cohesion: {range: 0.3, balance: 0.6, depth: 0.01, damping: 0.05}]
                """);
    }

    private static double farthest(ShortRun run) {
        double centre = 0;
        for (int i = 0; i < 64; i++) {
            centre += run.at(6 * i) / 64;
        }
        double farthest = 0;
        for (int x = 0; x < 6 * 64; x += 6) {
            farthest = Math.max(farthest, Math.hypot(run.at(x) - centre, Math.hypot(run.at(x + 1), run.at(x + 2))));
        }
        return farthest;
    }
}
