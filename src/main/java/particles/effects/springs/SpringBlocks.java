package particles.effects.springs;

import particles.law.DivisibleEffect;
import particles.law.Particles;

/**
 * A division of many springs into blocks that several threads can evaluate at once, and joints, as
 * {@link DivisibleEffect} says: each block has a range of particles to itself, and both ends of its springs are in
 * there. Springs that join two ranges come after all blocks. The division follows from the springs alone, not from the
 * number of threads, and each particle's force is added up in the order of the table: so it has the same bits, whoever
 * evaluates which block.
 */
final class SpringBlocks {
    /** Fewer springs are evaluated sooner than another thread is told of them. */
    private static final int SPRINGS_PER_BLOCK = 4096;
    /** More threads than that find no memory to keep them busy. */
    private static final int MOST = 16;
    /** Where more than this part of the springs join two ranges, as in a random network, nothing is to be gained. */
    private static final double MOST_BETWEEN = 0.25;

    private int count = 1;
    // the first spring of each block and joint, and where the last one ends
    private int[] starts = new int[2 * MOST];
    private int[] firstParticles = new int[MOST];       // of the blocks' ranges

    /**
     * Divides the springs.
     *
     * @param from  where their first particles stand in the state, in ascending order
     * @param to    where their second ones do
     * @param total how many springs there are
     * @return the springs in the order of blocks and joints, those of each in the order in which they were
     */
    int[] divide(int[] from, int[] to, int total) {
        count = Math.max(1, Math.min(MOST, Integer.highestOneBit(total / SPRINGS_PER_BLOCK)));
        int[] order = collect(from, to, total);
        if (total - starts[count] > MOST_BETWEEN * total) {
            count = 1;
            order = collect(from, to, total);
        }
        return order;
    }

    /** Sorts the springs by what they are in, as many to a range of particles as possible. */
    private int[] collect(int[] from, int[] to, int total) {
        for (int b = 1; b < count; b++) {
            firstParticles[b] = from[(int) ((long) total * b / count)] / Particles.STRIDE;
        }
        int[] home = new int[total];
        int[] next = new int[2 * count];
        for (int s = 0; s < total; s++) {
            home[s] = home(blockOf(from[s] / Particles.STRIDE), blockOf(to[s] / Particles.STRIDE));
            next[home[s] + 1]++;
        }
        for (int b = 0; b < 2 * count - 1; b++) {
            next[b + 1] += next[b];
        }
        System.arraycopy(next, 0, starts, 0, 2 * count);
        int[] order = new int[total];
        for (int s = 0; s < total; s++) {
            order[next[home[s]]++] = s;
        }
        return order;
    }

    private int blockOf(int particle) {
        int b = count - 1;
        while (b > 0 && particle < firstParticles[b]) {
            b--;
        }
        return b;
    }

    /** The block if both are the same, else the joint of the smallest part of the tree that has both. */
    private int home(int a, int b) {
        int level = Integer.SIZE - Integer.numberOfLeadingZeros(a ^ b);
        return 2 * count - (2 * count >> level) + (a >> level);
    }

    /** Springs are about to go, the others stay in their order and in their blocks. */
    void remove(boolean[] gone) {
        int[] before = starts.clone();
        int stay = 0;
        for (int s = 0, b = 0; b < 2 * count; s++) {
            while (b < 2 * count && before[b] == s) {
                starts[b++] = stay;
            }
            stay += s < gone.length && !gone[s] ? 1 : 0;
        }
    }

    /** Particles were taken out; the others moved up in their order, and the ranges with them. */
    void reindex(int[] newIndex) {
        int[] before = firstParticles.clone();
        for (int i = 0, stay = 0, b = 1; b < count; i++) {
            while (b < count && before[b] == i) {
                firstParticles[b++] = stay;
            }
            stay += i < newIndex.length && newIndex[i] >= 0 ? 1 : 0;
        }
    }

    /** How many blocks there are, a power of two. */
    int count() {
        return count;
    }

    /** The first spring of a block or a joint. */
    int start(int block) {
        return starts[block];
    }

    /** The first particle of a block's range. */
    int firstParticle(int block) {
        return firstParticles[block];
    }
}
