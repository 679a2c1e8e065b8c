package deSolvers.linear;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** Searches beside shortest paths through the set, found by going over all springs again and again. */
class LevelsTest {
    private static final int EDGE = 9;
    private static final BlockPattern PATTERN = FrontalFactorsTest.cloth(EDGE, EDGE);

    /**
     * How many springs each particle is away from the root on a way through the set; EDGE * EDGE where there is none.
     */
    private static int[] distances(int[] set, int root) {
        int[] distance = new int[PATTERN.rows];
        Arrays.fill(distance, PATTERN.rows);
        distance[root] = 0;
        boolean changed = true;
        while (changed) {
            changed = false;
            for (int i : set) {
                for (int j : set) {
                    if (PATTERN.find(i, j) >= 0 && distance[j] + 1 < distance[i]) {
                        distance[i] = distance[j] + 1;
                        changed = true;
                    }
                }
            }
        }
        return distance;
    }

    private static void assertFound(Levels levels, int[] set, int root) {
        int[] distance = distances(set, root);
        int[] found = IntStream.of(set).filter(i -> distance[i] < PATTERN.rows).toArray();
        assertEquals(found.length, levels.search(root, 0));
        assertEquals(IntStream.of(found).map(i -> distance[i]).max().orElseThrow(), levels.last);
        int[] size = new int[levels.last + 1];
        int[] touching = new int[levels.last + 1];
        for (int k = 0; k < found.length; k++) {
            int i = levels.queue[k];
            assertEquals(distance[i], levels.of(i));
            assertTrue(k == 0 || levels.of(levels.queue[k - 1]) <= levels.of(i), "level by level");
            boolean touches = IntStream.of(found).anyMatch(j -> PATTERN.find(i, j) >= 0 && distance[j] == distance[i]
                    + 1);
            assertEquals(touches, levels.touchesNext(i));
            size[distance[i]]++;
            touching[distance[i]] += touches ? 1 : 0;
        }
        assertEquals(Arrays.toString(size), Arrays.toString(Arrays.copyOf(levels.size, levels.last + 1)));
        assertEquals(Arrays.toString(touching), Arrays.toString(Arrays.copyOf(levels.touching, levels.last + 1)));
    }

    @Test
    void aSearchKeepsToItsSet() {
        Levels levels = new Levels(PATTERN);
        int[] all = IntStream.range(0, PATTERN.rows).toArray();
        int[] corner = IntStream.of(all).filter(i -> i / EDGE + i % EDGE <= 6).toArray();
        int[] rest = IntStream.of(all).filter(i -> i / EDGE + i % EDGE > 6).toArray();
        // each time, others have levels of the last search
        for (int[] set : new int[][] {all, corner, rest, corner}) {
            levels.begin(set, 0, set.length);
            for (int root : new int[] {set[0], set[set.length - 1], set[set.length / 2]}) {
                levels.forget();
                assertFound(levels, set, root);
            }
        }
    }

    @Test
    void aSearchFindsWhatIsConnected() {
        Levels levels = new Levels(PATTERN);
        int[] set = IntStream.range(0, PATTERN.rows).filter(i -> i % EDGE < 2 || i % EDGE > 4).toArray();
        levels.begin(set, 0, set.length);
        assertFound(levels, set, 0);
        assertFalse(levels.isUnknown(EDGE + 1));
        assertTrue(levels.isUnknown(EDGE + 5));
        assertFalse(levels.isUnknown(EDGE + 3), "is not of the set");
        int end = levels.search(EDGE + 5, 2 * EDGE);
        assertEquals(set.length, end, "the others stand behind the first");
        assertFalse(levels.isUnknown(EDGE + 5));
    }
}
