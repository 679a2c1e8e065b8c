package deSolvers.linear;

import java.util.Arrays;

/**
 * What an elimination does that depends on the pattern of a matrix alone. Particles whose rows fill in alike are
 * eliminated together, as a group: in a small full matrix, its front, of their own rows and those below that they fill
 * in. What is left of a front when its group is gone is added to the front of the group that the first of the rows
 * below is in.
 *
 * <p>Source: I. S. Duff, J. K. Reid (1983), ACM Trans. Math. Softw. 9, 302, for the multifrontal method; T. A. Davis,
 * <i>Direct Methods for Sparse Linear Systems</i>, SIAM 2006, for elimination trees.
 */
final class FrontalPlan {
    /** Groups are joined if no more than this part of their factors is zeros then: one larger front is done sooner. */
    private static final double MOST_ZEROS = 0.05;

    private final BlockPattern pattern;
    /** Whether there is a plan. */
    final boolean fits;
    /** The particles in the order of elimination, and the place of each in it. */
    final int[] order;
    final int[] place;
    /** How many groups there are; group g is of the places groupStart[g] to groupStart[g + 1] - 1. */
    final int groups;
    final int[] groupStart;
    /** Where the rows below each group stand in {@link #below}, which holds their places in ascending order. */
    final int[] belowStart;
    final int[] below;
    /** How many groups leave something to each. */
    final int[] children;
    /** The most particles in a front. */
    final int largestFront;
    /** The most blocks that are left of fronts, and not yet added to others, at a time. */
    final int mostLeft;
    /** The blocks below the diagonal of all groups. */
    final long blocks;
    /** Products of two blocks that the elimination of a matrix takes, and that of a symmetric one. */
    final long operations;
    final long symmetricOperations;
    private final int[] parent;                         // the elimination tree

    /** Finds the plan for a pattern, unless more blocks than the given number would fill in. */
    FrontalPlan(BlockPattern pattern, long mostBlocks) {
        this.pattern = pattern;
        int n = pattern.rows;
        order = NestedDissection.order(pattern);
        place = new int[n];
        parent = new int[n];
        number();
        findParents();
        if (sortByTree()) {
            number();
            findParents();
        }
        int[] count = countBelow();
        long filled = 0;
        for (int k = 0; k < n; k++) {
            filled += count[k];
        }
        fits = filled <= mostBlocks;
        int[] starts = new int[n + 1];
        groups = fits ? group(count, starts) : 0;
        groupStart = Arrays.copyOf(starts, groups + 1);
        children = new int[groups];
        belowStart = new int[groups + 1];
        below = findBelow();
        mostLeft = simulate();
        int largest = 0;
        long sumOfRows = 0;
        long products = 0;
        long symmetricProducts = 0;
        for (int g = 0; g < groups; g++) {
            largest = Math.max(largest, width(g) + height(g));
            for (long rows = height(g); rows < height(g) + width(g); rows++) {
                sumOfRows += rows;
                products += rows * (rows + 1);
                symmetricProducts += rows * (rows + 3) / 2;
            }
        }
        largestFront = largest;
        blocks = sumOfRows;
        operations = products;
        symmetricOperations = symmetricProducts;
    }

    private void number() {
        for (int k = 0; k < order.length; k++) {
            place[order[k]] = k;
        }
    }

    /** Where each row's first entry below the diagonal is, once it is filled in; -1 for rows without. */
    private void findParents() {
        int[] ancestor = new int[order.length];
        for (int i = 0; i < order.length; i++) {
            parent[i] = -1;
            ancestor[i] = -1;
            int from = order[i];
            for (int s = pattern.rowStart[from]; s < pattern.rowStart[from + 1]; s++) {
                for (int k = place[pattern.column[s]]; k >= 0 && k < i;) {
                    int next = ancestor[k];
                    ancestor[k] = i;
                    if (next < 0) {
                        parent[k] = i;
                    }
                    k = next;
                }
            }
        }
    }

    /**
     * Sorts so that each comes right after all that are above it in the tree; returns whether that changed anything.
     */
    private boolean sortByTree() {
        int n = order.length;
        int[] size = new int[n];
        // where the next of a parent's subtrees begins; n stands for none
        int[] next = new int[n + 1];
        boolean changed = false;
        for (int k = 0; k < n; k++) {
            size[k]++;
            if (parent[k] >= 0) {
                size[parent[k]] += size[k];
            }
        }
        int[] sorted = new int[n];
        int[] begin = new int[n];
        for (int k = n - 1; k >= 0; k--) {              // parents before children, the last child at the end
            int to = parent[k] < 0 ? n : parent[k];
            int end = to == n ? n - next[n] : begin[to] + size[to] - 1 - next[to];
            next[to] += size[k];
            begin[k] = end - size[k];
            sorted[end - 1] = order[k];
            changed |= end - 1 != k;
        }
        System.arraycopy(sorted, 0, order, 0, n);
        return changed;
    }

    /** How many rows below each are filled in. */
    private int[] countBelow() {
        int n = order.length;
        int[] count = new int[n];
        int[] seen = new int[n];
        Arrays.fill(seen, -1);
        for (int i = 0; i < n; i++) {
            int from = order[i];
            for (int s = pattern.rowStart[from]; s < pattern.rowStart[from + 1]; s++) {
                for (int k = place[pattern.column[s]]; k >= 0 && k < i && seen[k] != i; k = parent[k]) {
                    seen[k] = i;
                    count[k]++;
                }
            }
        }
        return count;
    }

    /**
     * Joins neighbours in the order to groups where that leaves few zeros in their factors; returns how many groups.
     */
    private int group(int[] count, int[] starts) {
        int n = order.length;
        long[] zeros = new long[n + 1];
        int found = 0;
        for (int k = 0; k < n; k++) {
            starts[found] = k;
            zeros[found++] = 0;
            while (found > 1 && parent[starts[found - 1] - 1] >= 0 && parent[starts[found - 1] - 1] <= k) {
                long upper = starts[found - 1] - starts[found - 2];
                long width = k + 1 - starts[found - 2];
                long more = upper * (width - upper + count[k] - count[starts[found - 1] - 1]);
                long all = zeros[found - 2] + zeros[found - 1] + more;
                if (all > MOST_ZEROS * width * (width / 2.0 + count[k])) {
                    break;
                }
                zeros[found - 2] = all;
                found--;
            }
        }
        starts[found] = n;
        return found;
    }

    /**
     * The rows below each group: those that its particles touch, and those below the groups that leave something to it.
     */
    private int[] findBelow() {
        int n = order.length;
        int[] groupOf = new int[n];
        for (int g = 0; g < groups; g++) {
            Arrays.fill(groupOf, groupStart[g], groupStart[g + 1], g);
        }
        int[] firstChild = new int[groups];
        int[] nextChild = new int[groups];
        int[] seen = new int[n];
        Arrays.fill(firstChild, -1);
        Arrays.fill(seen, -1);
        int[] rows = new int[4 * n];
        int end = 0;
        for (int g = 0; g < groups; g++) {
            rows = end + n > rows.length ? Arrays.copyOf(rows, 2 * rows.length) : rows;
            for (int k = groupStart[g]; k < groupStart[g + 1]; k++) {
                int from = order[k];
                for (int s = pattern.rowStart[from]; s < pattern.rowStart[from + 1]; s++) {
                    int row = place[pattern.column[s]];
                    if (row >= groupStart[g + 1] && seen[row] != g) {
                        seen[row] = g;
                        rows[end++] = row;
                    }
                }
            }
            for (int c = firstChild[g]; c >= 0; c = nextChild[c]) {
                for (int b = belowStart[c]; b < belowStart[c + 1]; b++) {
                    if (rows[b] >= groupStart[g + 1] && seen[rows[b]] != g) {
                        seen[rows[b]] = g;
                        rows[end++] = rows[b];
                    }
                }
            }
            belowStart[g + 1] = end;
            if (end > belowStart[g]) {
                Arrays.sort(rows, belowStart[g], end);
                int heir = groupOf[rows[belowStart[g]]];
                children[heir]++;
                nextChild[g] = firstChild[heir];
                firstChild[heir] = g;
            }
        }
        return Arrays.copyOf(rows, end);
    }

    /** The most blocks that wait at a time. */
    private int simulate() {
        int[] left = new int[groups];
        int waiting = 0;
        int all = 0;
        int most = 0;
        for (int g = 0; g < groups; g++) {
            for (int c = 0; c < children[g]; c++) {
                all -= left[--waiting];
            }
            int height = height(g);
            if (height > 0) {
                left[waiting++] = height * height;
                all += height * height;
            }
            most = Math.max(most, all);
        }
        return most;
    }

    /** How many particles are in a group. */
    int width(int g) {
        return groupStart[g + 1] - groupStart[g];
    }

    /** How many rows are below it. */
    int height(int g) {
        return belowStart[g + 1] - belowStart[g];
    }
}
