package deSolvers.linear;

import java.util.Arrays;
import java.util.stream.IntStream;

/**
 * Nested dissection: an order of elimination with little fill-in. A separator, a small set of rows, cuts the graph of
 * the matrix in two; each part is ordered in the same way, and the separator comes last, so that eliminating one part
 * never fills in the other. The separators are levels of a breadth-first search.
 *
 * <p>Source: J. A. George (1973), SIAM J. Numer. Anal. 10, 345; J. A. George, J. W. H. Liu (1978), SIAM J. Numer. Anal.
 * 15, 1053, for separators from level structures.
 */
final class NestedDissection {
    /** Sets of at most this number of rows are not cut. */
    private static final int SMALL = 4;
    /** Of all levels with at least this part of the rows on either side, the smallest is the separator. */
    private static final double SMALLEST_PART = 0.3;
    private static final int UNKNOWN = Integer.MAX_VALUE;

    private final BlockPattern pattern;
    private final int[] order;
    private final int[] queue;
    private final int[] level;                          // of each row, in the last search that found it

    private NestedDissection(BlockPattern pattern) {
        this.pattern = pattern;
        order = new int[pattern.rows];
        queue = new int[pattern.rows];
        level = new int[pattern.rows];
    }

    /** @return all rows in the order of their elimination */
    static int[] order(BlockPattern pattern) {
        NestedDissection dissection = new NestedDissection(pattern);
        dissection.dissect(IntStream.range(0, pattern.rows).toArray(), 0);
        return dissection.order;
    }

    /** Orders rows from a place on. None of them touches a row that was ordered before. */
    private void dissect(int[] all, int place) {
        int[] rows = all;
        int begin = place;
        while (rows.length > SMALL) {
            int found = search(rows, rows[0]);
            int separator = UNKNOWN - 1;                // not connected: nothing to separate
            if (found == rows.length) {
                search(rows, queue[found - 1]);         // again, from a row at the rim
                separator = separator(found);
                if (separator == 0) {
                    break;
                }
            }
            int[] below = part(rows, separator, -1);
            int[] above = part(rows, separator, 1);
            int[] between = part(rows, separator, 0);
            System.arraycopy(between, 0, order, begin + rows.length - between.length, between.length);
            dissect(below, begin);
            begin += below.length;
            rows = above;
        }
        System.arraycopy(rows, 0, order, begin, rows.length);
    }

    /** The rows at levels below the separator (-1), in it (0) or above it (1). */
    private int[] part(int[] rows, int separator, int side) {
        return Arrays.stream(rows).filter(i -> Integer.compare(level[i], separator) == side).toArray();
    }

    /** Sorts the rows connected to the root into levels; returns their number. */
    private int search(int[] rows, int root) {
        for (int i : rows) {
            level[i] = UNKNOWN;
        }
        int found = 0;
        queue[found++] = root;
        level[root] = 0;
        for (int next = 0; next < found; next++) {
            int i = queue[next];
            for (int s = pattern.rowStart[i]; s < pattern.rowStart[i + 1]; s++) {
                int j = pattern.column[s];
                if (level[j] == UNKNOWN) {
                    level[j] = level[i] + 1;
                    queue[found++] = j;
                }
            }
        }
        return found;
    }

    /** The level to cut at; 0 if there are fewer than three. */
    private int separator(int rows) {
        int last = level[queue[rows - 1]];
        int[] size = new int[last + 1];
        for (int k = 0; k < rows; k++) {
            size[level[queue[k]]]++;
        }
        int best = 0;
        boolean bestIsBalanced = false;
        int below = size[0];
        for (int l = 1; l < last; below += size[l++]) {
            boolean balanced = Math.min(below, rows - below - size[l]) >= SMALLEST_PART * rows;
            if (best == 0 || balanced && !bestIsBalanced || balanced == bestIsBalanced && size[l] < size[best]) {
                best = l;
                bestIsBalanced = balanced;
            }
        }
        return best;
    }
}
