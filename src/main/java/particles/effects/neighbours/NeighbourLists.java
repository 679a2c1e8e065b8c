package particles.effects.neighbours;

import java.util.Arrays;
import particles.law.Particles;

/**
 * Verlet neighbour lists: for each ball, the balls that touch it or are within a margin of it. They are made from a
 * {@link NeighbourGrid}, and made again once a ball has moved by half the margin. Each list is sorted by index, or by
 * cube, so a sum over it is the same, bit for bit, whenever the list was made: the lists depend on positions, not on
 * time.
 *
 * <p>Source: L. Verlet, "Computer 'experiments' on classical fluids" (1967).
 */
public final class NeighbourLists {
    /**
     * The margin as a fraction of the largest radius. For 2,000 balls that fall into a box, 0.3 takes 1.12 times as
     * long; 0.8 takes 0.98 of the time, but the lists are longer.
     */
    private static final double MARGIN = 0.6;
    private static final int STRIDE = Particles.STRIDE;

    int[] start = {0};                                  // where the list of a ball begins in near
    int[] later = {};                                   // where those with a larger index begin
    int[] near = {};
    private final NeighbourGrid grid = new NeighbourGrid();
    private double[] listed = {};                       // the positions for which the lists were made
    private int[] pairs = {};                           // two entries a pair
    private int[] unsorted = {};
    private int[] next = {};
    private int[] found = {};
    private final boolean betweenFixed;
    private boolean sorted;                             // by cubes
    private long[] cubes = {};                          // by which the lists are sorted, three a particle
    private boolean[] crossed = {};                     // whether a particle is in another cube than at the last call

    /** @param betweenFixed whether two fixed balls can be neighbours */
    public NeighbourLists(boolean betweenFixed) {
        this.betweenFixed = betweenFixed;
    }

    /**
     * Makes the lists again if they may have become wrong.
     *
     * @param state     the particles' state, of which only positions are used
     * @param particles the balls
     * @param radii     the radius of each (m)
     * @param largest   the largest of them (m)
     */
    public void update(double[] state, Particles particles, double[] radii, double largest) {
        double margin = MARGIN * largest;
        if (listed.length != 3 * particles.count() || !(farthestMove(state) <= margin * margin / 4)) {
            grid.build(state, particles.count(), 2 * largest + margin);
            list(state, particles, radii, margin);
            sorted = false;
        }
    }

    /**
     * Sorts the later neighbours of each particle by their cubes of this width, in the order of x, y, z, and those in
     * the same cube by index: as {@link NeighbourGrid#findLater} lists them. Called after each update.
     *
     * @param state the particles' state
     * @param width the width of the cubes (m)
     */
    public void sortByCubes(double[] state, double width) {
        int n = later.length;
        boolean all = cubes.length != 3 * n || !sorted;
        sorted = true;
        if (cubes.length != 3 * n) {
            cubes = new long[3 * n];
            crossed = new boolean[n];
        }
        for (int i = 0; i < n; i++) {
            crossed[i] = all;
            for (int c = 0; c < 3; c++) {
                long cube = NeighbourGrid.cube(state[STRIDE * i + c], width);
                crossed[i] |= cube != cubes[3 * i + c];
                cubes[3 * i + c] = cube;
            }
        }
        for (int i = 0; i < n; i++) {
            boolean any = false;
            for (int k = later[i]; k < start[i + 1]; k++) {
                any |= crossed[near[k]];
            }
            if (any) {
                sortRow(later[i], start[i + 1]);
            }
        }
    }

    /** Insertion sort: hardly anything moves, except in new lists. */
    private void sortRow(int first, int end) {
        for (int k = first + 1; k < end; k++) {
            int j = near[k];
            int place = k;
            for (; place > first && precedes(j, near[place - 1]); place--) {
                near[place] = near[place - 1];
            }
            near[place] = j;
        }
    }

    private boolean precedes(int i, int j) {
        for (int c = 0; c < 3; c++) {
            if (cubes[3 * i + c] != cubes[3 * j + c]) {
                return cubes[3 * i + c] < cubes[3 * j + c];
            }
        }
        return i < j;
    }

    /**
     * Returns the lists, one after the other.
     *
     * @return indices of particles; valid until the next update
     */
    public int[] getNear() {
        return near;
    }

    /**
     * @param i   a particle
     * @param all whether all its neighbours are meant, or those with a larger index
     * @return where they begin in {@link #getNear}
     */
    public int first(int i, boolean all) {
        return all ? start[i] : later[i];
    }

    /**
     * @param i a particle
     * @return where its list ends
     */
    public int end(int i) {
        return start[i + 1];
    }

    /** @return the sum of the lists' lengths */
    public int size() {
        return start[start.length - 1];
    }

    /** Has the lists made at the next update. */
    public void forget() {
        listed = new double[0];
    }

    /** The square of the farthest that a particle has moved since the lists were made. */
    private double farthestMove(double[] state) {
        double most = 0;
        for (int i = 0, x = 0; i < listed.length; i += 3, x += STRIDE) {
            double dx = state[x] - listed[i];
            double dy = state[x + 1] - listed[i + 1];
            double dz = state[x + 2] - listed[i + 2];
            most = Math.max(most, dx * dx + dy * dy + dz * dz);
        }
        return most;
    }

    /** Lists all pairs, then the candidates of each particle. */
    private void list(double[] state, Particles particles, double[] radii, double margin) {
        int n = particles.count();
        if (listed.length != 3 * n) {
            listed = new double[3 * n];
            start = new int[n + 1];
            later = new int[n];
            next = new int[n];
            found = new int[n];
        }
        int count = 0;
        Arrays.fill(start, 0);
        for (int i = 0; i < n; i++) {
            System.arraycopy(state, STRIDE * i, listed, 3 * i, 3);
            int candidates = grid.findAhead(i, found);
            if (count + 2 * candidates > pairs.length) {
                pairs = Arrays.copyOf(pairs, 2 * (count + 2 * candidates));
            }
            for (int k = 0; k < candidates; k++) {
                int j = found[k];
                double reach = radii[i] + radii[j] + margin;
                if (square(state, i, j) < reach * reach
                        && (betweenFixed || !particles.isFixed(i) || !particles.isFixed(j))) {
                    pairs[count++] = i;
                    pairs[count++] = j;
                    start[i + 1]++;
                    start[j + 1]++;
                }
            }
        }
        for (int i = 0; i < n; i++) {
            start[i + 1] += start[i];
        }
        sort(n, count);
    }

    /**
     * Enters both particles of each pair in each other's list, then each particle, in the order of indices, in the
     * lists of its neighbours: these are then in that order.
     */
    private void sort(int n, int count) {
        if (near.length < count) {
            near = new int[pairs.length];
            unsorted = new int[pairs.length];
        }
        System.arraycopy(start, 0, next, 0, n);
        for (int k = 0; k < count; k += 2) {
            unsorted[next[pairs[k]]++] = pairs[k + 1];
            unsorted[next[pairs[k + 1]]++] = pairs[k];
        }
        System.arraycopy(start, 0, next, 0, n);
        for (int i = 0; i < n; i++) {
            later[i] = next[i];
            for (int k = start[i]; k < start[i + 1]; k++) {
                near[next[unsorted[k]]++] = i;
            }
        }
    }

    private static double square(double[] state, int i, int j) {
        double dx = state[STRIDE * i] - state[STRIDE * j];
        double dy = state[STRIDE * i + 1] - state[STRIDE * j + 1];
        double dz = state[STRIDE * i + 2] - state[STRIDE * j + 2];
        return dx * dx + dy * dy + dz * dz;
    }
}
