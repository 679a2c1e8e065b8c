package particles.effects.springs;

import java.util.Arrays;
import java.util.stream.IntStream;
import particles.law.DivisibleEffect;
import particles.law.Particles;

/**
 * Divides springs into the blocks and joints of {@link DivisibleEffect}, for several threads. A block has a range of
 * particles to itself and all springs with both ends in it; springs between two ranges are in joints, evaluated after
 * the blocks. The division does not depend on the number of threads, and each particle's force is summed in the order
 * of the table, so the result has the same bits on any number of threads.
 */
final class SpringBlocks {
    /** For fewer springs, waking another thread takes longer than evaluating them. */
    private static final int SPRINGS_PER_BLOCK = 4096;
    /** The largest number of blocks; more threads would only wait for memory. */
    private static final int MOST = 16;
    /** Springs are not divided if more than this fraction of them join two ranges, as in a random network. */
    private static final double MOST_BETWEEN = 0.25;

    private int count = 1;
    // the first spring of each block and joint, and where the last one ends
    private int[] starts = new int[2 * MOST];
    private int[] firstParticles = new int[MOST];       // of the blocks' ranges

    /**
     * Assigns the springs to blocks and joints.
     *
     * @param from  the state indices of the springs' first particles, ascending
     * @param to    the state indices of their second particles
     * @param total the number of springs
     * @return the springs sorted by block and joint; within each they keep their order
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

    /** Sorts the springs by block or joint. */
    private int[] collect(int[] from, int[] to, int total) {
        for (int b = 1; b < count; b++) {
            firstParticles[b] = from[(int) ((long) total * b / count)] / Particles.STRIDE;
        }
        int[] home = IntStream.range(0, total).map(s -> home(blockOf(from[s] / Particles.STRIDE),
                blockOf(to[s] / Particles.STRIDE))).toArray();
        Arrays.fill(starts, 0);
        for (int part : home) {
            starts[part + 1]++;
        }
        for (int part = 1; part < starts.length; part++) {
            starts[part] += starts[part - 1];
        }
        return order(home, total);
    }

    /** The springs in the order of their keys; those with the same key keep theirs. */
    static int[] order(int[] key, int total) {
        return IntStream.range(0, total).mapToLong(s -> (long) key[s] << Integer.SIZE | s).sorted()
                .mapToInt(place -> (int) place).toArray();
    }

    private int blockOf(int particle) {
        int b = count - 1;
        while (b > 0 && particle < firstParticles[b]) {
            b--;
        }
        return b;
    }

    /** The block itself if a = b, otherwise the joint of the smallest subtree that contains both. */
    private int home(int a, int b) {
        int level = Integer.SIZE - Integer.numberOfLeadingZeros(a ^ b);
        return 2 * count - (2 * count >> level) + (a >> level);
    }

    /** The number of blocks, a power of two. */
    int count() {
        return count;
    }

    /** The first spring of a block or a joint. */
    int start(int block) {
        return starts[block];
    }
}
