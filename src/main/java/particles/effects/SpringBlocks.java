package particles.effects;

import particles.Memory;
import particles.Particles;

/**
 * A division of many springs into blocks that several threads can evaluate at once: each block has a range of particles to
 * itself, and both ends of its springs are in there. Springs that join two ranges come after all blocks. The division follows
 * from the springs alone, not from the number of threads, and each particle's force is added up in the order of the table: so
 * it has the same bits, whoever evaluates which block.
 */
final class SpringBlocks {
    /** Fewer springs are evaluated sooner than another thread is told of them. */
    private static final int SPRINGS_PER_BLOCK = 4096;
    /** More threads than that find no memory to keep them busy. */
    private static final int MOST = 16;
    /** Where more than this part of the springs join two ranges, as in a random network, nothing is to be gained. */
    private static final double MOST_BETWEEN = 0.25;

    private int count = 1;
    private int[] starts = new int[MOST + 1];           // the first spring of each block; then the first that joins two

    /**
     * Divides the springs.
     *
     * @param from  where their first particles stand in the state, in ascending order
     * @param to    where their second ones do
     * @param total how many springs there are
     * @return the springs in the order of blocks, each block and the rest in the order in which they were
     */
    int[] divide(int[] from, int[] to, int total) {
        count = Math.max(1, Math.min(MOST, Integer.highestOneBit(total / SPRINGS_PER_BLOCK)));
        int[] order = new int[total];
        int inside = count == 1 ? total : collect(from, to, total, order);
        if (total - inside > MOST_BETWEEN * total) {
            count = 1;
            inside = total;
        }
        if (count == 1) {
            for (int s = 0; s < total; s++) {
                order[s] = s;
            }
            starts[0] = 0;
        }
        starts[count] = inside;
        return order;
    }

    /** Puts the springs within ranges first, as many to a range as possible; returns how many they are. */
    private int collect(int[] from, int[] to, int total, int[] order) {
        int[] firstParticle = new int[count + 1];
        for (int b = 1; b < count; b++) {
            firstParticle[b] = from[(int) ((long) total * b / count)];
        }
        firstParticle[count] = Integer.MAX_VALUE;
        int inside = 0;
        int between = total;
        for (int s = 0, b = -1; s < total; s++) {
            while (b < 0 || from[s] >= firstParticle[b + 1]) {
                starts[++b] = inside;
            }
            if (to[s] >= firstParticle[b] && to[s] < firstParticle[b + 1]) {
                order[inside++] = s;
            } else {
                order[--between] = s;
            }
        }
        for (int a = between, z = total - 1; a < z; a++, z--) {  // those were put down from behind
            int s = order[a];
            order[a] = order[z];
            order[z] = s;
        }
        return inside;
    }

    /** Springs are about to go, the others stay in their order and in their blocks. */
    void remove(boolean[] gone) {
        int[] before = starts.clone();
        int stay = 0;
        for (int s = 0, b = 0; b <= count; s++) {
            while (b <= count && before[b] == s) {
                starts[b++] = stay;
            }
            stay += s < gone.length && !gone[s] ? 1 : 0;
        }
    }

    void remember(Memory memory) {
        count = memory.keep(count);
        starts = memory.keep(starts, MOST + 1);
    }

    /** How many blocks there are, 1 or more. */
    int count() {
        return count;
    }

    /** The first spring of a block; of block {@link #count()}, the first one that joins two ranges. */
    int start(int block) {
        return starts[block];
    }
}
