package particles.effects.springs;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import particles.ParticleSystem;
import particles.law.Vector3;

/**
 * The order in which springs are evaluated, and their blocks for several threads, agree with a plain list through every
 * change.
 */
class SpringOrderTest {
    private static final int PARTICLES = 3000;

    /** A spring: the indices of its two particles and a unique number. */
    private record Spring(int from, int to, int number) {
        boolean isWithin(int first, int end) {
            return from >= first && to >= first && from < end && to < end;
        }
    }

    private final ParticleSystem system = new ParticleSystem();
    private final SpringForce springs = new SpringForce(system.getParticles());

    private void addParticles(int count) {
        for (int i = 0; i < count; i++) {
            system.addParticle("p" + i, 1, Vector3.ZERO, Vector3.ZERO, false);
        }
        system.addEffect(springs);
    }

    private Spring add(int from, int to, int number) {
        springs.addSpring(from, to, number, number + 0.25, number + 0.5);
        return new Spring(from, to, number);
    }

    /** Adds springs between particles whose indices differ by at most {@code reach}. */
    private List<Spring> addRandom(int count, int particles, int reach) {
        addParticles(particles);
        Random random = new Random(count);
        List<Spring> all = new ArrayList<>();
        for (int s = 0; s < count; s++) {
            int from = random.nextInt(particles - reach);
            int other = from + 1 + random.nextInt(reach);
            all.add(s % 7 == 3 ? add(other, from, s) : add(from, other, s));
        }
        return all;
    }

    private List<Spring> present(int first, int end) {
        return IntStream.range(first, end).mapToObj(s -> {
            int number = (int) springs.stiffness(s);
            assertEquals(number + 0.25, springs.restLength(s));
            assertEquals(number + 0.5, springs.damping(s));
            return new Spring(springs.from(s), springs.to(s), number);
        }).toList();
    }

    private static List<Spring> sorted(List<Spring> springs) {
        return springs.stream().sorted(Comparator.comparingInt(Spring::from)).toList();     // a stable sort
    }

    /**
     * A block holds all springs within its range of particles, and the rest all others; each part is sorted by first
     * particles.
     */
    private void assertArranged(int blocks, List<Spring> expected) {
        assertEquals(blocks, springs.countBlocks());
        List<Spring> rest = new ArrayList<>(sorted(expected));
        int[] firstParticles = new int[blocks + 1];
        for (int block = 1; block < blocks; block++) {
            firstParticles[block] = rest.get(rest.size() * block / blocks).from;
        }
        firstParticles[blocks] = system.getParticles().count();
        for (int block = 0; block < blocks; block++) {
            int first = firstParticles[block];
            int end = firstParticles[block + 1];
            List<Spring> within = rest.stream().filter(spring -> spring.isWithin(first, end)).toList();
            assertEquals(within, present(springs.getPartStart(block), springs.getPartStart(block + 1)));
            rest.removeAll(new HashSet<>(within));
        }
        assertEquals(rest, present(springs.getPartStart(blocks), expected.size()));
        assertEquals(expected.size(), springs.size());
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 7, 8, 9, 100})
    void springsAreSortedByTheirFirstParticle(int count) {
        List<Spring> all = addRandom(count, 30, 12);
        assertEquals(all, present(0, count), "before sorting, in the order of adding");
        assertArranged(1, all);
        assertArranged(1, all);
    }

    /** A spring that begins before the last one is sorted in; one that begins at the same particle stays last. */
    @ParameterizedTest
    @CsvSource({"20, 1", "9000, 2"})
    void springsAddedLaterAreSortedInToo(int count, int blocks) {
        List<Spring> all = addRandom(count, PARTICLES, 40);
        for (int from : new int[] {2950, 2950, 0, 7}) {
            assertArranged(blocks, all);
            all = new ArrayList<>(sorted(all));
            all.add(add(from, 2951, all.size()));
        }
        assertArranged(blocks, all);
    }

    /** Springs are removed alone, or with either of their ends; the number of blocks is a power of two. */
    @ParameterizedTest
    @CsvSource({"200, 1, 1, 1", "8191, 1, 1, 1", "8192, 2, 1, 1", "16384, 4, 2, 2", "40000, 8, 4, 4"})
    void whatIsLeftAfterARemovalIsArrangedAnew(int count, int blocks, int blocksOfTwoThirds, int blocksAtLast) {
        List<Spring> all = addRandom(count, PARTICLES, 100);
        assertArranged(blocks, all);
        boolean[] gone = new boolean[count];
        List<Spring> stay = new ArrayList<>();
        for (int s = 0; s < count; s++) {
            gone[s] = s % 3 == 1;
            stay.addAll(gone[s] ? List.of() : present(s, s + 1));
        }
        springs.removeSprings(gone);
        assertEquals(stay, present(0, stay.size()));
        assertArranged(blocksOfTwoThirds, stay);
        List<Spring> arranged = present(0, stay.size());
        boolean[] dead = new boolean[PARTICLES];
        for (int i = 0; i < PARTICLES; i++) {
            dead[i] = i % 11 == 0;
        }
        int[] newIndex = system.removeParticles(dead);
        List<Spring> left = arranged.stream().filter(s -> !dead[s.from] && !dead[s.to])
                .map(s -> new Spring(newIndex[s.from], newIndex[s.to], s.number)).toList();
        assertArranged(blocksAtLast, left);
    }

    /**
     * In a random network most springs join two ranges; up to a quarter may, in a chain of two blocks of 4096 springs.
     */
    @ParameterizedTest
    @CsvSource({"2047, 2", "2048, 1", "2049, 1"})
    void springsAreDividedIfAtMostAQuarterJoinTwoRanges(int joining, int blocks) {
        addParticles(8193);
        assertArranged(blocks, IntStream.range(0, 8192).mapToObj(s -> add(s, s < joining ? 5000 : s + 1, s)).toList());
    }

    @Test
    void allSpringsActInSomePart() {
        addRandom(20_000, PARTICLES, 100);
        double[] state = new Random(4).doubles(system.getStateSize()).toArray();
        double[] together = new double[state.length];
        springs.addForces(state, 0, together);
        double[] inParts = new double[state.length];
        for (int part = springs.countBlocks(); part >= 0; part--) {
            springs.addPart(part, state, 0, inParts);
        }
        double[] bySprings = new double[state.length];
        for (int s = springs.size() - 1; s >= 0; s--) {
            SpringForce one = new SpringForce(system.getParticles());
            one.addSpring(springs.from(s), springs.to(s), springs.stiffness(s), springs.restLength(s),
                    springs.damping(s));
            one.addForces(state, 0, bySprings);
        }
        double largest = Arrays.stream(bySprings).map(Math::abs).max().orElseThrow();
        assertArrayEquals(bySprings, together, 1e-14 * largest);
        assertArrayEquals(bySprings, inParts, 1e-14 * largest);
    }
}
