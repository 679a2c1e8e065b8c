package deSolvers.linear;

import java.util.Arrays;

/**
 * The particles of a set, sorted by breadth: into levels by how many springs they are away from one of them, the root.
 * A search goes no way through particles outside the set.
 */
final class Levels {
    private static final int UNKNOWN = -1;
    private static final int OUTSIDE = Integer.MAX_VALUE;

    private final BlockPattern pattern;
    /** The particles found, level by level. */
    final int[] queue;
    /** Of each level: how many particles are in it, and how many of them touch the next one. */
    final int[] size;
    final int[] touching;
    /** The last level. */
    int last;
    private final int[] level;                          // of each particle
    private final int[] member;                         // of the set
    private int members;

    Levels(BlockPattern pattern) {
        this.pattern = pattern;
        queue = new int[pattern.rows];
        size = new int[pattern.rows];
        touching = new int[pattern.rows];
        level = new int[pattern.rows];
        Arrays.fill(level, OUTSIDE);
        member = new int[pattern.rows];
    }

    /** Makes some particles the set, instead of those that were it. */
    void begin(int[] particles, int from, int to) {
        for (int k = 0; k < members; k++) {
            level[member[k]] = OUTSIDE;
        }
        members = to - from;
        System.arraycopy(particles, from, member, 0, members);
        forget();
    }

    /** Forgets what searches have found. */
    void forget() {
        for (int k = 0; k < members; k++) {
            level[member[k]] = UNKNOWN;
        }
    }

    /** Whether no search has come to a particle of the set yet. */
    boolean isUnknown(int i) {
        return level[i] == UNKNOWN;
    }

    /** The level of a particle of the set. */
    int of(int i) {
        return level[i];
    }

    /** Sorts what is connected to a root, from a place in the queue on; returns where it ends there. */
    int search(int root, int at) {
        int end = at;
        queue[end++] = root;
        level[root] = 0;
        last = -1;
        for (int next = at; next < end; next++) {
            int i = queue[next];
            int nextLevel = level[i] + 1;
            boolean touches = false;
            for (int s = pattern.rowStart[i]; s < pattern.rowStart[i + 1]; s++) {
                int j = pattern.column[s];
                if (level[j] == UNKNOWN) {
                    level[j] = nextLevel;
                    queue[end++] = j;
                }
                touches |= level[j] == nextLevel;
            }
            count(level[i], touches);
        }
        return end;
    }

    private void count(int l, boolean touches) {
        if (l > last) {
            last = l;
            size[l] = 0;
            touching[l] = 0;
        }
        size[l]++;
        touching[l] += touches ? 1 : 0;
    }

    /** Whether a particle of the set touches one on the next level. */
    boolean touchesNext(int i) {
        for (int s = pattern.rowStart[i]; s < pattern.rowStart[i + 1]; s++) {
            if (level[pattern.column[s]] == level[i] + 1) {
                return true;
            }
        }
        return false;
    }
}
