package particles.effects.springs;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import particles.ParticleSystem;
import particles.law.Vector3;

/** Springs in blocks and joints: which particles each touches, that all springs act, and removal of particles. */
class SpringBlocksTest {
    private static final int PARTICLES = 3000;

    /** Springs, in random order, between particles whose indices differ by at most {@code reach}. */
    private static ParticleSystem network(int reach) {
        ParticleSystem network = new ParticleSystem();
        Random random = new Random(11);
        for (int i = 0; i < PARTICLES; i++) {
            network.addParticle("p" + i, 1, new Vector3(random.nextDouble(), random.nextDouble(), i * 0.01),
                    Vector3.ZERO, false);
        }
        SpringForce springs = new SpringForce(network.getParticles());
        for (int s = 0; s < 20_000; s++) {
            int i = random.nextInt(PARTICLES);
            int j = Math.floorMod(i + 1 + random.nextInt(reach), PARTICLES);
            springs.addSpring(i, j, random.nextDouble(), 0.5, 0.25);
        }
        network.addEffect(springs);
        return network;
    }

    private static SpringForce springs(ParticleSystem network) {
        return (SpringForce) network.getEffects().get(0);
    }

    @Test
    void allSpringsActInBlocksAndJoints() {
        ParticleSystem network = network(100);
        SpringForce springs = springs(network);
        double[] state = new Random(4).doubles(network.getStateSize()).toArray();
        double[] together = new double[state.length];
        springs.addForces(state, 0, together);
        double[] inParts = new double[state.length];
        for (int part = 2 * springs.countBlocks() - 2; part >= 0; part--) {
            springs.addPart(part, state, 0, inParts);
        }
        double[] bySprings = new double[state.length];
        for (int s = springs.size() - 1; s >= 0; s--) {
            SpringForce one = new SpringForce(network.getParticles());
            one.addSpring(springs.from(s), springs.to(s), springs.stiffness(s), springs.restLength(s),
                    springs.damping(s));
            one.addForces(state, 0, bySprings);
        }
        assertArrayEquals(bySprings, together, 1e-14);          // measured 8.9e-16
        assertArrayEquals(bySprings, inParts, 1e-14);           // measured 8.9e-16
    }

    /** A block touches only its own particles; a joint touches both of its halves. */
    private static void assertRanges(SpringForce springs, int blocks, int particles) {
        assertEquals(blocks, springs.countBlocks());
        assertEquals(0, springs.getFirstParticle(0));
        assertEquals(particles, springs.getFirstParticle(blocks));
        assertEquals(0, springs.getPartStart(0));
        assertEquals(springs.size(), springs.getPartStart(2 * blocks - 1));
        for (int length = 1, home = 0; length <= blocks; length *= 2) {
            for (int block = 0; block < blocks; block += length, home++) {
                int first = springs.getFirstParticle(block);
                int middle = springs.getFirstParticle(block + length / 2);
                int end = springs.getFirstParticle(block + length);
                assertTrue(first < end, "block " + home);
                for (int s = springs.getPartStart(home); s < springs.getPartStart(home + 1); s++) {
                    int low = Math.min(springs.from(s), springs.to(s));
                    int high = Math.max(springs.from(s), springs.to(s));
                    assertTrue(first <= low && high < end, "spring " + s + " of block " + home);
                    assertTrue(length == 1 || low < middle && middle <= high, "spring " + s + " of joint " + home);
                }
            }
        }
    }

    /** Otherwise threads would lose forces. */
    @ParameterizedTest
    @ValueSource(ints = {40, 100, 250})
    void blocksShareNoParticles(int reach) {
        ParticleSystem network = network(reach);
        SpringForce springs = springs(network);
        assertRanges(springs, 4, 3000);
        for (int b = 0; b < 4; b++) {
            assertTrue(springs.getPartStart(b + 1) - springs.getPartStart(b) > 3000, "block " + b);     // of 20,000/4
        }
        for (int joint = 4; joint < 7; joint++) {
            assertTrue(springs.getPartStart(joint) < springs.getPartStart(joint + 1), "joint " + joint);
        }
        boolean[] gone = new boolean[3000];
        for (int i = 0; i < gone.length; i++) {
            gone[i] = i < 500 || i % 11 == 0;
        }
        network.removeParticles(gone);
        assertRanges(springs, 2, network.getParticles().count());      // of 13,000 springs
        assertEquals(1, springs(network(2999)).countBlocks());      // too many springs between ranges
    }
}
