package particles.effects.springs;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import particles.Systems;
import particles.law.Particles;
import particles.law.Vector3;

/**
 * Springs evaluated one by one and particle by particle, also of lengths of which the square overflows, compared with
 * the slide's formula for random positions and velocities.
 */
class SpringKernelTest {
    private static final int STRIDE = Particles.STRIDE;
    private static final int PARTICLES = 6;

    private record Spring(int from, int to, double stiffness, double restLength, double damping) {
    }

    private static Vector3 at(double[] state, int place) {
        return new Vector3(state[place], state[place + 1], state[place + 2]);
    }

    /** The slide's damped spring: (k (|r| - l) + k_d dv . r/|r|) r/|r| on the one end, its opposite on the other. */
    private static double[] byTheSlide(List<Spring> springs, double[] state) {
        double[] force = new double[state.length];
        for (Spring s : springs) {
            int i = STRIDE * s.from();
            int j = STRIDE * s.to();
            Vector3 r = at(state, j).minus(at(state, i));
            if (r.length() == 0) {
                continue;
            }
            Vector3 along = r.normalized();
            double rate = at(state, j + 3).minus(at(state, i + 3)).dot(along);
            Vector3 f = along.times(s.stiffness() * (r.length() - s.restLength()) + s.damping() * rate);
            double[] parts = {f.x(), f.y(), f.z()};
            for (int c = 0; c < 3; c++) {
                force[i + 3 + c] += parts[c];
                force[j + 3 + c] -= parts[c];
            }
        }
        return force;
    }

    private static double[] byTheLoops(List<Spring> springs, double[] state) {
        SpringForce effect = new SpringForce(Systems.row(PARTICLES).getParticles());
        springs.forEach(s -> effect.addSpring(s.from(), s.to(), s.stiffness(), s.restLength(), s.damping()));
        double[] force = new double[state.length];
        effect.addForces(state, 0, force);
        return force;
    }

    private static void assertLaw(List<Spring> springs, double[] state) {
        double[] expected = byTheSlide(springs, state);
        double[] actual = byTheLoops(springs, state);
        double largest = Arrays.stream(expected).map(Math::abs).max().orElseThrow();
        assertArrayEquals(expected, actual, 1e-14 * largest);               // measured: 1.5e-15
    }

    private static double[] state(Random random, double size) {
        return random.doubles(STRIDE * PARTICLES, -size, size).toArray();
    }

    private static Spring spring(int from, int to, Random random, double size) {
        return new Spring(from, to, 1 + random.nextDouble(), size * random.nextDouble(), 1 + random.nextDouble());
    }

    /** A chain, evaluated spring by spring, and a net, particle by particle. */
    @ParameterizedTest
    @ValueSource(doubles = {1, 1e100, 1e-100, 1e145, 1e-145, 1e250, 1e-250})
    void chainsAndNetsFollowTheLawAtAllSizes(double size) {
        Random random = new Random(715);
        for (int reach : new int[] {1, PARTICLES}) {
            for (int n = 0; n < 50; n++) {
                List<Spring> springs = new ArrayList<>();
                for (int i = 0; i < PARTICLES - 1; i++) {
                    for (int j = Math.min(PARTICLES - 1, i + reach); j > i; j--) {
                        springs.add(spring(i, j, random, size));
                    }
                }
                assertLaw(springs, state(random, size));
            }
        }
    }

    /** Long springs, short ones, one of ordinary size and one of length 0, all at one particle of a net. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 5})
    void extremeLengthsAmongOrdinaryOnesFollowTheLaw(int special) {
        Random random = new Random(special);
        double[] state = state(random, 1);
        double far = special % 2 == 0 ? 1e150 : 0;
        for (int c = 0; c < 3; c++) {
            state[STRIDE * special + c] = state[c] + far * (c + 1);
        }
        List<Spring> star = new ArrayList<>();
        for (int j = 1; j < PARTICLES; j++) {
            star.add(spring(0, j, random, 1));
        }
        assertLaw(star, state);
    }

    /** Divided by such a length the force would overflow, and times 0 m it would be NaN. */
    @Test
    void endsTooCloseForADirectionFeelNoForce() {
        double[] state = new double[STRIDE * PARTICLES];
        state[STRIDE] = 1e-306;
        assertArrayEquals(new double[state.length], byTheLoops(List.of(new Spring(0, 1, 1000, 1, 0)), state));
    }

    /** The bound between the two loops: two springs a particle. */
    @Test
    void twoSpringsAParticleAreEvaluatedTogether() {
        SpringTable table = new SpringTable();
        for (int from : new int[] {0, 0, 1}) {
            table.add(from, 2, 0, 0, 0);
        }
        table.countBlocks();
        assertFalse(table.isGrouped(), "3 springs of 2 particles");
        table.add(1, 3, 0, 0, 0);
        table.countBlocks();
        assertTrue(table.isGrouped(), "4 springs of 2 particles");
        table.removeSprings(new boolean[] {true, false, false, false});
        table.countBlocks();
        assertFalse(table.isGrouped(), "counted again: 3 of 2");
    }
}
