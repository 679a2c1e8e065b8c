package deSolvers.linear;

import java.util.Arrays;

/**
 * An order in which the particles of a sparse matrix can be eliminated with little fill-in. Particles at loose ends
 * come first; they fill in nothing. The others are cut in two by a separator, which comes last of the three; then each
 * part is cut again. Separators are found by breadth: of a set's {@link Levels} from a root, those particles of a
 * middle one that touch the next part what is nearer from what is farther. The best separator of several roots is
 * taken. They lie far from each other: the first at the rim, each further one where it is farthest from those before
 * it.
 *
 * <p>Source: J. A. George (1973), SIAM J. Numer. Anal. 10, 345; J. A. George, J. W. H. Liu (1978), SIAM J. Numer. Anal.
 * 15, 1053, for level structures; T. F. Gonzalez (1985), Theor. Comput. Sci. 38, 293, for points far from each other.
 */
final class NestedDissection {
    /** Sets of no more particles than this are not cut. */
    private static final int SMALL = 4;
    /** Each part should have at least this part of a set's particles; of such separators the smallest is taken. */
    private static final double SMALLEST_PART = 0.3;
    /**
     * Roots that are tried. With one a cloth takes 1.16 times the products; with twelve it takes 0.99 times as many.
     */
    private static final int MOST_ROOTS = 8;

    private final BlockPattern pattern;
    /** The particles; those of a set stand together, where they will be in the order. */
    private final int[] order;
    private final Levels levels;
    private final int[] distance;                       // of each particle: to the nearest root of its set
    private double least;                               // what the best separator of a set costs, its root and level
    private int bestRoot;
    private int bestLevel;
    private int[] open = new int[64];                   // beginnings and ends of sets that may have to be cut
    private int opened;

    private NestedDissection(BlockPattern pattern) {
        this.pattern = pattern;
        order = new int[pattern.rows];
        levels = new Levels(pattern);
        distance = new int[pattern.rows];
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

    /**
     * Puts first, one after the other, all that touch no more than one of those that are left; returns how many they
     * are.
     */
    private int takeLooseEnds() {
        int n = pattern.rows;
        int[] touched = new int[n];
        boolean[] loose = new boolean[n];
        int ends = 0;
        for (int i = 0; i < n; i++) {
            touched[i] = pattern.rowStart[i + 1] - pattern.rowStart[i] - 1;
            if (touched[i] <= 1) {
                order[ends++] = i;
                loose[i] = true;
            }
        }
        for (int e = 0; e < ends; e++) {
            int i = order[e];
            for (int s = pattern.rowStart[i]; s < pattern.rowStart[i + 1]; s++) {
                int j = pattern.column[s];
                touched[j]--;
                if (!loose[j] && touched[j] <= 1) {
                    order[ends++] = j;
                    loose[j] = true;
                }
            }
        }
        for (int i = 0, k = ends; i < n; i++) {
            if (!loose[i]) {
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
        levels.begin(order, from, to);
        int end = levels.search(order[from], 0);
        if (end < to - from) {
            openComponents(from, to, end);
        } else {
            findSeparator(from, to, levels.queue[end - 1]);
            levels.forget();
            levels.search(bestRoot, 0);
            cut(from, to);
        }
    }

    /** What is not connected needs no separator. */
    private void openComponents(int from, int to, int firstEnd) {
        open(from, from + firstEnd);
        int end = firstEnd;
        for (int k = from; k < to; k++) {
            if (levels.isUnknown(order[k])) {
                int begin = end;
                end = levels.search(order[k], begin);
                open(from + begin, from + end);
            }
        }
        System.arraycopy(levels.queue, 0, order, from, to - from);
    }

    private void findSeparator(int from, int to, int first) {
        least = Double.POSITIVE_INFINITY;
        for (int k = from; k < to; k++) {
            distance[order[k]] = Integer.MAX_VALUE;
        }
        int root = first;
        for (int roots = 0; roots < MOST_ROOTS && distance[root] > 0; roots++) {
            levels.forget();
            levels.search(root, 0);
            compareLevels(root, to - from);
            distance[root] = 0;
            for (int k = from; k < to; k++) {
                int i = order[k];
                distance[i] = Math.min(distance[i], levels.of(i));
                root = distance[i] > distance[root] ? i : root;
            }
        }
    }

    /**
     * Looks for a better separator among the levels from a root. Of two equal ones the one that halves better is
     * better.
     */
    private void compareLevels(int root, int size) {
        for (int l = 0, near = 0; l < levels.last; l++) {
            near += levels.size[l];
            int touching = levels.touching[l];
            double smaller = Math.min(near - touching, size - near);
            double larger = Math.max(near - touching, size - near);
            double cost = touching + (larger - smaller) / size + size * Math.max(0, SMALLEST_PART * size - smaller);
            if (cost < least) {
                least = cost;
                bestRoot = root;
                bestLevel = l;
            }
        }
    }

    /** Cuts the set that stands in the queue, sorted by levels from the best root, behind the best of them. */
    private void cut(int from, int to) {
        int[] queue = levels.queue;
        int size = to - from;
        int near = from;
        int separator = to;
        for (int k = 0; k < size && levels.of(queue[k]) <= bestLevel; k++) {
            if (levels.of(queue[k]) == bestLevel && levels.touchesNext(queue[k])) {
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
}
