package particles.effects.springs;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import particles.law.DivisibleEffect;
import particles.law.Particles;
import particles.law.Vector3;
import particles.view.SpringView;

/**
 * The data of all springs in flat arrays, sorted into the order in which their forces are evaluated fastest. Springs
 * can be added and removed; they are removed with their particles.
 *
 * <p>For several threads the springs are divided into the parts of {@link DivisibleEffect}: a block has a range of
 * particles to itself and all springs with both ends in it, and the rest has those between two ranges. The division
 * does not depend on the number of threads, and each particle's force is summed in the order of the table.
 */
class SpringTable implements SpringView {
    /** For fewer springs, waking another thread takes longer than evaluating them. */
    private static final int SPRINGS_PER_BLOCK = 4096;
    /** With more blocks, one thread would evaluate a larger rest alone: in a cloth of 128 x 128, 5 % with eight. */
    private static final int MOST_BLOCKS = 8;
    /** Springs are not divided if more than this fraction of them join two ranges, as in a random network. */
    private static final double MOST_BETWEEN = 0.25;

    int count;
    int[] from = new int[8];                            // state index of the first particle
    int[] to = new int[8];
    double[] stiffness = new double[8];
    double[] restLength = new double[8];
    double[] damping = new double[8];
    private final List<Consumer<int[]>> followers = new ArrayList<>(0);
    // how many particles begin springs, in the order of the table
    private int owners;
    private boolean arranged;
    private int blocks = 1;
    private int[] starts = {};                          // the first spring of each part, and where the last one ends

    void add(int i, int j, double stiffness, double restLength, double damping) {
        if (count == from.length) {
            int capacity = Math.max(8, count + count / 2);
            from = Arrays.copyOf(from, capacity);
            to = Arrays.copyOf(to, capacity);
            this.stiffness = Arrays.copyOf(this.stiffness, capacity);
            this.restLength = Arrays.copyOf(this.restLength, capacity);
            this.damping = Arrays.copyOf(this.damping, capacity);
        }
        from[count] = Particles.STRIDE * i;
        to[count] = Particles.STRIDE * j;
        this.stiffness[count] = stiffness;
        this.restLength[count] = restLength;
        this.damping[count] = damping;
        count++;
        arranged = false;
    }

    /** A spring is removed with either of its ends; called after particles were removed. */
    public final void reindex(int[] newIndex) {
        boolean[] gone = new boolean[count];
        for (int s = 0; s < count; s++) {
            int i = newIndex[from[s] / Particles.STRIDE];
            int j = newIndex[to[s] / Particles.STRIDE];
            gone[s] = i < 0 || j < 0;
            from[s] = Particles.STRIDE * i;
            to[s] = Particles.STRIDE * j;
        }
        removeSprings(gone);
    }

    /**
     * Removes springs.
     *
     * @param gone for each spring, whether to remove it
     */
    public final void removeSprings(boolean[] gone) {
        put(IntStream.range(0, count).filter(s -> !gone[s]).toArray());
        arranged = false;
    }

    /** @return the number of blocks; sorts and divides the springs if some were added or removed */
    public final int countBlocks() {
        if (!arranged) {
            arrange();
        }
        return blocks;
    }

    /**
     * Sorts the springs by their first particle, so that its position, velocity and force stay in registers for all of
     * its springs; then divides them into blocks.
     */
    private void arrange() {
        arranged = true;
        put(order(from));
        // a power of two, so that two or four threads get as much to do
        blocks = Integer.highestOneBit(Math.max(1, Math.min(MOST_BLOCKS, count / SPRINGS_PER_BLOCK)));
        int[] parts = findParts();
        if (Arrays.stream(parts).filter(part -> part == blocks).count() > MOST_BETWEEN * count) {
            blocks = 1;
            parts = findParts();
        }
        put(order(parts));
        Arrays.sort(parts);
        starts = new int[blocks + 2];
        for (int part = 0, s = 0; part <= blocks; starts[++part] = s) {
            while (s < count && parts[s] == part) {
                s++;
            }
        }
        owners = 0;
        for (int s = 0; s < count; s++) {
            owners += s == 0 || from[s] != from[s - 1] ? 1 : 0;
        }
    }

    /** @return the first spring of a part; it ends where the next one begins */
    public final int getPartStart(int part) {
        return starts[part];
    }

    /** The part of each spring: the block in whose range both its ends are, or the rest. */
    private int[] findParts() {
        int[] bounds = IntStream.range(1, blocks).map(b -> from[(int) ((long) count * b / blocks)]).toArray();
        return IntStream.range(0, count).map(s -> {
            int block = blockOf(from[s], bounds);
            return block == blockOf(to[s], bounds) ? block : blocks;
        }).toArray();
    }

    private static int blockOf(int particle, int[] bounds) {
        int block = 0;
        while (block < bounds.length && particle >= bounds[block]) {
            block++;
        }
        return block;
    }

    /** The springs in the order of their keys; those with the same key keep theirs. */
    private int[] order(int[] key) {
        return IntStream.range(0, count).mapToLong(s -> (long) key[s] << Integer.SIZE | s).sorted()
                .mapToInt(place -> (int) place).toArray();
    }

    /** @return whether particles begin enough springs, two or more on average, to evaluate them together */
    boolean isGrouped() {
        return count >= 2L * owners;
    }

    /**
     * @param state the particles' state
     * @param s     a spring
     * @return its present length |r| (m)
     */
    public final double length(double[] state, int s) {
        Vector3 r = way(state, s, 0);
        double square = r.dot(r);
        return SpringKernel.isOrdinary(square) ? Math.sqrt(square) : r.length();
    }

    /** d|r|/dt of spring s (m/s), 0 where its ends are at the same place. */
    double lengthRate(double[] state, int s) {
        double length = length(state, s);
        Vector3 r = way(state, s, 0);
        return length > 0 ? r.over(length).dot(way(state, s, 3)) : 0;
    }

    /** r = x_j - x_i of spring s, or r' with an offset of 3. */
    private Vector3 way(double[] state, int s, int offset) {
        return Vector3.at(state, to[s] + offset).minus(Vector3.at(state, from[s] + offset));
    }

    /** Keeps these springs, in this order. */
    private void put(int[] order) {
        from = Arrays.stream(order).map(s -> from[s]).toArray();
        to = Arrays.stream(order).map(s -> to[s]).toArray();
        stiffness = permuted(stiffness, order);
        restLength = permuted(restLength, order);
        damping = permuted(damping, order);
        count = order.length;
        followers.forEach(follower -> follower.accept(order));
    }

    /**
     * For laws that keep indices of springs.
     *
     * @param follower receives, whenever springs are sorted or removed, the old index of each that is left, by its new
     *                 one
     */
    public final void onReorder(Consumer<int[]> follower) {
        followers.add(follower);
    }

    /** @return the number of springs */
    public final int size() {
        return count;
    }

    @Override
    public final int springCount() {
        return count;
    }

    @Override
    public final int from(int s) {
        return from[s] / Particles.STRIDE;
    }

    @Override
    public final int to(int s) {
        return to[s] / Particles.STRIDE;
    }

    @Override
    public final double restLength(int s) {
        return restLength[s];
    }

    @Override
    public final double stiffness(int s) {
        return stiffness[s];
    }

    @Override
    public final double damping(int s) {
        return damping[s];
    }

    private static double[] permuted(double[] values, int[] order) {
        return Arrays.stream(order).mapToDouble(s -> values[s]).toArray();
    }
}
