package particles.effects.neighbours;

import java.util.Arrays;
import particles.law.Particles;

/**
 * Neighbour search by spatial hashing: space is divided into cubes as wide as the range, so that all particles within
 * range are in the particle's own cube or the 26 around it. Cubes are kept in a hash table, so that particles may be
 * anywhere; within a cube they are in the order of their indices. Work and memory are proportional to the number of
 * particles as long as the cubes do not get more crowded.
 *
 * <p>Source: M. Teschner et al., "Optimized spatial hashing for collision detection of deformable objects", VMV 2003.
 */
public final class NeighbourGrid {
    private static final int STRIDE = Particles.STRIDE;

    private long[] cubes = {};                          // three coordinates a particle
    private int[] bucketStart = {1};                    // where the particles of a bucket begin in sorted
    private int[] sorted = {};

    /**
     * Sorts particles into cubes.
     *
     * @param state the particles' state, of which only positions are used
     * @param count the number of particles
     * @param range the largest distance at which particles must be found (m), positive
     */
    public void build(double[] state, int count, double range) {
        if (sorted.length < count) {
            cubes = new long[3 * count + count];
            sorted = new int[count + count / 3];
        }
        int buckets = Integer.highestOneBit(Math.max(1, count)) * 2;
        if (bucketStart.length != buckets + 1) {
            bucketStart = new int[buckets + 1];
        }
        Arrays.fill(bucketStart, 0);
        for (int i = 0; i < count; i++) {
            for (int c = 0; c < 3; c++) {
                cubes[3 * i + c] = cube(state[STRIDE * i + c], range);
            }
            bucketStart[bucket(hash(cubes[3 * i], cubes[3 * i + 1]), cubes[3 * i + 2])]++;
        }
        int end = 0;
        // bucketStart holds ends here; sorting from the last particle down turns them into starts
        for (int b = 0; b <= buckets; b++) {
            end += bucketStart[b];
            bucketStart[b] = end;
        }
        for (int i = count - 1; i >= 0; i--) {
            sorted[--bucketStart[bucket(hash(cubes[3 * i], cubes[3 * i + 1]), cubes[3 * i + 2])]] = i;
        }
    }

    /** The cube of this width in which a coordinate is. */
    static long cube(double coordinate, double width) {
        double quotient = coordinate / width;
        long whole = (long) quotient;
        return quotient < whole ? whole - 1 : whole;
    }

    private static long hash(long x, long y) {
        long hash = x * 73856093L ^ y * 19349663L;
        hash ^= hash >>> 32;
        return hash ^ hash >>> 16;
    }

    /** Cubes in a row along z have buckets in a row, so that three of them are one stretch of particles. */
    private int bucket(long hash, long z) {
        return (int) (hash + z) & bucketStart.length - 2;
    }

    /**
     * Lists candidates for neighbours of particle i with a larger index, each once and always in the same order. All
     * those within range are among them; the caller checks the distance.
     *
     * @param i     a particle
     * @param found receives their indices; its length is at least the number of particles
     * @return the number of candidates
     */
    public int findLater(int i, int[] found) {
        int all = 0;
        for (long x = cubes[3 * i] - 1; x <= cubes[3 * i] + 1; x++) {
            for (long y = cubes[3 * i + 1] - 1; y <= cubes[3 * i + 1] + 1; y++) {
                all = addRow(x, y, cubes[3 * i + 2] - 1, cubes[3 * i + 2] + 1, found, all);
            }
        }
        int count = 0;
        for (int k = 0; k < all; k++) {
            int j = found[k];
            found[count] = j;
            count += j > i ? 1 : 0;
        }
        return count;
    }

    /** As {@link #findLater}, in half the time: each pair is listed once, by either of its particles. */
    int findAhead(int i, int[] found) {
        long x = cubes[3 * i];
        long y = cubes[3 * i + 1];
        long z = cubes[3 * i + 2];
        int own = addRow(x, y, z, z + 1, found, 0);
        int count = 0;
        for (int k = 0; k < own; k++) {
            int j = found[k];
            found[count] = j;
            count += j > i || cubes[3 * j + 2] > z ? 1 : 0;
        }
        count = addRow(x, y + 1, z - 1, z + 1, found, count);
        for (long row = y - 1; row <= y + 1; row++) {
            count = addRow(x + 1, row, z - 1, z + 1, found, count);
        }
        return count;
    }

    /** Appends the particles in the cubes from (x, y, z) to (x, y, last). */
    private int addRow(long x, long y, long z, long last, int[] found, int count) {
        long hash = hash(x, y);
        while (z <= last) {
            int first = bucket(hash, z);
            int end = (int) Math.min(first + last + 1 - z, bucketStart.length - 1);     // and on with bucket 0
            for (int s = bucketStart[first]; s < bucketStart[end]; s++) {
                int j = sorted[s];
                if (cubes[3 * j] == x && cubes[3 * j + 1] == y && cubes[3 * j + 2] >= z && cubes[3 * j + 2] <= last) {
                    found[count++] = j;
                }
            }
            z += end - first;
        }
        return count;
    }
}
