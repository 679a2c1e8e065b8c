package deSolvers.linear;

import java.util.Arrays;

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
        for (int i = 0; i < order.length; i++) {
            order[i] = i;
        }
    }

    /** @return all rows in the order of their elimination */
    static int[] order(BlockPattern pattern) {
        NestedDissection dissection = new NestedDissection(pattern);
        dissection.dissect(0, pattern.rows);
        return dissection.order;
    }

    /** Orders the rows that stand in a range of the order. None of them touches a row of a range ordered before. */
    private void dissect(int begin, int finish) {
        int from = begin;
        int end = finish;
        while (end - from > SMALL) {
            int found = search(from, end, order[from]);
            int separator = UNKNOWN - 1;                // not connected: nothing to separate
            if (found == end - from) {
                search(from, end, queue[found - 1]);    // again, from a row at the rim
                separator = separator(found);
                if (separator == 0) {
                    return;
                }
            }
            int middle = sort(from, end, separator);
            while (level[order[end - 1]] == separator) {
                end--;
            }
            dissect(from, middle);
            from = middle;
        }
    }

    /** Sorts the rows connected to the root into levels; returns their number. */
    private int search(int from, int end, int root) {
        for (int k = from; k < end; k++) {
            level[order[k]] = UNKNOWN;
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

    /**
     * Puts the levels below the separator first, those above it next, and the separator last; returns where the second
     * begin.
     */
    private int sort(int from, int end, int separator) {
        int[] rows = Arrays.copyOfRange(order, from, end);
        int to = from;
        int middle = from;
        for (int part = -1; part <= 1; part++) {
            for (int i : rows) {
                int compared = Integer.compare(level[i], separator);
                if (part == -1 ? compared < 0 : part == 0 ? compared > 0 : compared == 0) {
                    order[to++] = i;
                }
            }
            middle = part == -1 ? to : middle;
        }
        return middle;
    }
}
