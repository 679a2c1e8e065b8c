package particles.effects.springs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.Iterator;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import particles.law.Particles;

/** The flat arrays of springs agree with a plain list through every operation. */
class SpringTableTest {
    private static final int STRIDE = Particles.STRIDE;

    /** A spring: the indices of its two particles and a unique number. */
    private record Spring(int from, int to, int number) {
    }

    private static Spring spring(SpringTable table, int s) {
        int number = (int) table.stiffness[s];
        assertEquals(number + 0.25, table.restLength[s]);
        assertEquals(number + 0.5, table.damping[s]);
        return new Spring(table.from[s] / STRIDE, table.to[s] / STRIDE, number);
    }

    private static List<Spring> springs(SpringTable table, int from, int to) {
        List<Spring> springs = new ArrayList<>();
        for (int s = from; s < to; s++) {
            springs.add(spring(table, s));
        }
        return springs;
    }

    private static List<Spring> springs(SpringTable table) {
        return springs(table, 0, table.count);
    }

    private static List<Spring> random(int count, int particles, int reach, SpringTable table) {
        Random random = new Random(count);
        List<Spring> springs = new ArrayList<>();
        for (int s = 0; s < count; s++) {
            int from = random.nextInt(particles - reach);
            int other = from + 1 + random.nextInt(reach);
            Spring spring = s % 7 == 3 ? new Spring(other, from, s) : new Spring(from, other, s);
            springs.add(spring);
            table.add(spring.from, spring.to, s, s + 0.25, s + 0.5);
        }
        return springs;
    }

    private static List<Spring> sorted(List<Spring> springs) {
        return springs.stream().sorted(Comparator.comparingInt(Spring::from)).toList();     // a stable sort
    }

    private static void assertArranged(List<Spring> expected, SpringTable table) {
        table.arrange();
        assertEquals(sorted(expected), springs(table));
        assertEquals(1, table.getBlocks().count());
        assertEquals(0, table.getBlocks().start(0));
        assertEquals(expected.size(), table.getBlocks().start(1));
        long owners = expected.stream().mapToInt(Spring::from).distinct().count();
        assertEquals(expected.size() >= 2 * owners, table.isGrouped());
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 7, 8, 9, 100})
    void springsAreSortedByTheirFirstParticle(int count) {
        SpringTable table = new SpringTable();
        List<Spring> springs = random(count, 30, 12, table);
        assertEquals(springs, springs(table), "before sorting, in the order of adding");
        assertArranged(springs, table);
        assertArranged(springs, table);
    }

    /** A spring that begins before the last one is sorted in; one that begins at the same particle stays last. */
    @Test
    void springsAddedLaterAreSortedInToo() {
        SpringTable table = new SpringTable();
        List<Spring> springs = new ArrayList<>(random(20, 30, 12, table));
        assertArranged(springs, table);
        for (int from : new int[] {29, 29, 0, 7}) {
            springs = new ArrayList<>(sorted(springs));
            Spring more = new Spring(from, 3, springs.size());
            springs.add(more);
            table.add(more.from, more.to, more.number, more.number + 0.25, more.number + 0.5);
            assertArranged(springs, table);
        }
    }

    /** The bound itself: two springs a particle. */
    @Test
    void twoSpringsAParticleAreEvaluatedTogether() {
        SpringTable table = new SpringTable();
        for (int from : new int[] {0, 0, 1}) {
            table.add(from, 2, 0, 0, 0);
        }
        table.arrange();
        assertFalse(table.isGrouped(), "3 springs of 2 particles");
        table.add(1, 3, 0, 0, 0);
        table.arrange();
        assertTrue(table.isGrouped(), "4 springs of 2 particles");
        table.remove(new boolean[] {true, false, false, false});
        table.arrange();
        assertFalse(table.isGrouped(), "counted again: 3 of 2");
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void aSpringIsRemovedWithEitherOfItsEnds(boolean arranged) {
        SpringTable table = new SpringTable();
        List<Spring> springs = random(200, 30, 12, table);
        if (arranged) {
            table.arrange();
            springs = sorted(springs);
        }
        int[] newIndex = new int[30];                   // particles 0, 5, 10 ... are removed, the others move up
        for (int i = 0; i < newIndex.length; i++) {
            newIndex[i] = i % 5 == 0 ? -1 : i - i / 5 - 1;
        }
        List<Spring> left = springs.stream().filter(s -> s.from % 5 != 0 && s.to % 5 != 0)
                .map(s -> new Spring(newIndex[s.from], newIndex[s.to], s.number)).toList();
        assertTrue(left.size() > 50 && left.size() < 150);
        assertTrue(left.stream().anyMatch(s -> s.from == 0) && left.stream().anyMatch(s -> s.to == 0),
                "the new first particle keeps its springs");
        table.reindex(newIndex);
        assertEquals(left, springs(table));
        assertArranged(left, table);
    }

    /** Within a block and within a joint springs are sorted, also when the others are removed. */
    @ParameterizedTest
    @ValueSource(ints = {8191, 8192, 16_384, 40_000})
    void springsAreSortedInTheirBlocks(int count) {
        SpringTable table = new SpringTable();
        random(count, 3000, 40, table);
        table.arrange();
        assertEquals(count < 8192 ? 1 : count < 16_384 ? 2 : count < 32_768 ? 4 : 8, table.getBlocks().count());
        assertSortedParts(count, table);
        boolean[] gone = new boolean[count];
        for (int s = 0; s < count; s++) {
            gone[s] = s % 3 == 1;
        }
        table.remove(gone);
        table.arrange();
        assertSortedParts(count - (count + 1) / 3, table);
    }

    private static void assertSortedParts(int count, SpringTable table) {
        List<List<Spring>> parts = parts(table);
        assertEquals(count, parts.stream().flatMap(List::stream).distinct().count());
        for (int b = 0; b < parts.size(); b++) {
            assertEquals(sorted(parts.get(b)), parts.get(b), "block or joint " + b);
        }
    }

    /** The springs of each block and of each joint. */
    private static List<List<Spring>> parts(SpringTable table) {
        SpringBlocks blocks = table.getBlocks();
        assertEquals(0, blocks.start(0));
        List<List<Spring>> parts = new ArrayList<>();
        for (int b = 0; b < 2 * blocks.count() - 1; b++) {
            parts.add(springs(table, blocks.start(b), blocks.start(b + 1)));
        }
        assertEquals(table.count, blocks.start(2 * blocks.count() - 1));
        return parts;
    }

    /** A block holds all springs within its range, a joint the others within its two ranges. */
    @Tag("slow")
    @ParameterizedTest
    @ValueSource(ints = {8192, 20_000, 40_000})
    void aBlockHoldsAllSpringsWithinItsRange(int count) {
        SpringTable table = new SpringTable();
        List<Spring> springs = sorted(random(count, 3000, 40, table));
        table.arrange();
        int blocks = table.getBlocks().count();
        int[] first = new int[blocks + 1];
        for (int b = 1; b < blocks; b++) {
            first[b] = springs.get((int) ((long) count * b / blocks)).from;
            assertEquals(first[b], table.getBlocks().firstParticle(b));
        }
        first[blocks] = Integer.MAX_VALUE;
        List<Spring> rest = new ArrayList<>(springs);
        Iterator<List<Spring>> parts = parts(table).iterator();
        for (int length = 1; length <= blocks; length *= 2) {
            for (int b = 0; b < blocks; b += length) {
                int from = first[b];
                int to = first[b + length];
                List<Spring> within = rest.stream().filter(s -> s.from >= from && s.to >= from && s.from < to
                        && s.to < to).toList();
                assertEquals(within, parts.next());
                rest.removeAll(within);
            }
        }
        assertFalse(parts.hasNext());
    }

    /**
     * In a random network most springs join two ranges; up to a quarter may, in a chain of two blocks of 4096 springs.
     */
    @Test
    void springsAreDividedIfAtMostAQuarterJoinTwoRanges() {
        for (int joining : new int[] {2047, 2048, 2049}) {
            SpringTable table = new SpringTable();
            for (int s = 0; s < 8192; s++) {
                table.add(s, s < joining ? 5000 : s + 1, s, s + 0.25, s + 0.5);
            }
            table.arrange();
            assertEquals(joining < 2048 ? 2 : 1, table.getBlocks().count(), joining + " and one more join two ranges");
            assertEquals(joining < 2048 ? 8192 - 2048 : 8192, table.getBlocks().start(table.getBlocks().count()));
        }
    }

    /** After adding one spring, a divided table is sorted and divided as if all springs were new. */
    @Test
    void addingASpringDividesTheBlocksAnew() {
        SpringTable table = new SpringTable();
        List<Spring> springs = random(9000, 3000, 40, table);
        table.arrange();
        SpringTable fresh = new SpringTable();
        for (Spring spring : sorted(springs)) {
            fresh.add(spring.from, spring.to, spring.number, spring.number + 0.25, spring.number + 0.5);
        }
        for (SpringTable each : List.of(table, fresh)) {
            each.add(2950, 2951, 9000, 9000.25, 9000.5);        // begins behind the last, which joins two blocks
            each.arrange();
        }
        assertEquals(2, table.getBlocks().count());
        assertEquals(parts(fresh).stream().map(List::size).toList(), parts(table).stream().map(List::size).toList());
        for (int b = 0; b < 2; b++) {
            assertEquals(sorted(parts(table).get(b)), parts(table).get(b), "in order, block " + b);
        }
    }
}
