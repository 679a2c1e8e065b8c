package deSolvers.implicit;

import java.util.Arrays;

/**
 * An order in which the particles of a sparse matrix can be eliminated with little fill-in. Particles at loose ends come
 * first; they fill in nothing. The others are cut in two by a separator, which comes last of the three; then each part is cut
 * again. Separators are found by breadth: all particles of a set are sorted into levels by how many springs they are away from
 * one at the rim, and those of a middle level that touch the next one part what is nearer from what is farther.
 *
 * <p>Source: J. A. George (1973), SIAM J. Numer. Anal. 10, 345; J. A. George, J. W. H. Liu (1978), SIAM J. Numer. Anal. 15,
 * 1053, for level structures.
 */
final class NestedDissection {
    /** Sets of no more particles than this are not cut. */
    private static final int SMALL = 4;
    /** Each part should have at least this part of a set's particles; of such separators the smallest is taken. */
    private static final double SMALLEST_PART = 0.25;
    /** How often the search for a particle at the rim goes on from the farthest one. */
    private static final int MOST_SEARCHES = 4;

    private final BlockPattern pattern;
    /** The particles; those of a set stand together, where they will be in the order. */
    private final int[] order;
    private final int[] set;                            // of each particle: the number of its set
    private final int[] level;                          // of each particle in its set, -1 where it is not known
    private final int[] queue;
    private int sets;
    private int[] open = new int[64];                   // beginnings and ends of sets that may have to be cut
    private int opened;

    private NestedDissection(BlockPattern pattern) {
        this.pattern = pattern;
        order = new int[pattern.rows];
        set = new int[pattern.rows];
        level = new int[pattern.rows];
        queue = new int[pattern.rows];
    }

    /** @return the particles in the order of their elimination */
    static int[] order(BlockPattern pattern) {
        NestedDissection dissection = new NestedDissection(pattern);
        dissection.open(dissection.takeLooseEnds(), pattern.rows);
        while (dissection.opened > 0) {
            dissection.opened -= 2;
            dissection.split(dissection.open[dissection.opened], dissection.open[dissection.opened + 1]);
        }
        return dissection.order;
    }

    /** Puts first, one after the other, all that touch no more than one of those that are left; returns how many they are. */
    private int takeLooseEnds() {
        int n = pattern.rows;
        int[] touched = level;
        int ends = 0;
        for (int i = 0; i < n; i++) {
            touched[i] = pattern.rowStart[i + 1] - pattern.rowStart[i] - 1;
            if (touched[i] <= 1) {
                order[ends++] = i;
                set[i] = -1;
            }
        }
        for (int e = 0; e < ends; e++) {
            int i = order[e];
            for (int s = pattern.rowStart[i]; s < pattern.rowStart[i + 1]; s++) {
                int j = pattern.column[s];
                touched[j]--;
                if (set[j] == 0 && touched[j] <= 1) {
                    order[ends++] = j;
                    set[j] = -1;
                }
            }
        }
        for (int i = 0, k = ends; i < n; i++) {
            if (set[i] == 0) {
                order[k++] = i;
            }
        }
        return ends;
    }

    private void open(int from, int to) {
        if (to - from <= SMALL) {
            return;
        }
        if (opened == open.length) {
            open = Arrays.copyOf(open, 2 * opened);
        }
        open[opened++] = from;
        open[opened++] = to;
    }

    private void split(int from, int to) {
        sets++;
        for (int k = from; k < to; k++) {
            set[order[k]] = sets;
        }
        forgetLevels(from, to);
        int end = search(order[from], 0);
        if (end < to - from) {
            openComponents(from, to, end);
            return;
        }
        for (int searches = 1, depth = -1; searches < MOST_SEARCHES && level[queue[end - 1]] > depth; searches++) {
            int farthest = queue[end - 1];
            depth = level[farthest];
            forgetLevels(from, to);
            search(farthest, 0);
        }
        cut(from, to);
    }

    private void forgetLevels(int from, int to) {
        for (int k = from; k < to; k++) {
            level[order[k]] = -1;
        }
    }

    /** Sorts what is connected to a particle by breadth, from a place in the queue on; returns where it ends there. */
    private int search(int first, int at) {
        int number = set[first];
        int end = at;
        queue[end++] = first;
        level[first] = 0;
        for (int next = at; next < end; next++) {
            int i = queue[next];
            int nextLevel = level[i] + 1;
            for (int s = pattern.rowStart[i]; s < pattern.rowStart[i + 1]; s++) {
                int j = pattern.column[s];
                if (set[j] == number && level[j] < 0) {
                    level[j] = nextLevel;
                    queue[end++] = j;
                }
            }
        }
        return end;
    }

    /** What is not connected needs no separator. */
    private void openComponents(int from, int to, int firstEnd) {
        open(from, from + firstEnd);
        int end = firstEnd;
        for (int k = from; k < to; k++) {
            if (level[order[k]] < 0) {
                int begin = end;
                end = search(order[k], begin);
                open(from + begin, from + end);
            }
        }
        System.arraycopy(queue, 0, order, from, to - from);
    }

    /** Cuts the set that stands in the queue, sorted by level, behind the best of them. */
    private void cut(int from, int to) {
        int size = to - from;
        int last = level[queue[size - 1]];
        int best = -1;
        double least = Double.POSITIVE_INFINITY;
        for (int l = 0, k = 0; l < last; l++) {
            int touching = 0;
            for (; level[queue[k]] == l; k++) {
                touching += touchesNext(queue[k]) ? 1 : 0;
            }
            double smallest = Math.min(k - touching, size - k);
            double cost = touching + size * Math.max(0, SMALLEST_PART * size - smallest);
            if (cost < least) {
                least = cost;
                best = l;
            }
        }
        int near = from;
        int separator = to;
        for (int k = 0; k < size && level[queue[k]] <= best; k++) {
            if (level[queue[k]] == best && touchesNext(queue[k])) {
                order[--separator] = queue[k];
            } else {
                order[near++] = queue[k];
            }
        }
        System.arraycopy(queue, size - (separator - near), order, near, separator - near);
        if (near > from) {                              // else each touches each, nearly
            open(from, near);
            open(near, separator);
        }
    }

    private boolean touchesNext(int i) {
        for (int s = pattern.rowStart[i]; s < pattern.rowStart[i + 1]; s++) {
            int j = pattern.column[s];
            if (set[j] == set[i] && level[j] > level[i]) {
                return true;
            }
        }
        return false;
    }
}
