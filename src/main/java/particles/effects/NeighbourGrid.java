package particles.effects;

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
                cubes[3 * i + c] = floor(state[STRIDE * i + c] / range);
            }
            bucketStart[bucket(cubes[3 * i], cubes[3 * i + 1], cubes[3 * i + 2])]++;
        }
        int end = 0;
        // bucketStart holds ends here; sorting from the last particle down turns them into starts
        for (int b = 0; b <= buckets; b++) {
            end += bucketStart[b];
            bucketStart[b] = end;
        }
        for (int i = count - 1; i >= 0; i--) {
            sorted[--bucketStart[bucket(cubes[3 * i], cubes[3 * i + 1], cubes[3 * i + 2])]] = i;
        }
    }

    private static long floor(double quotient) {
        long whole = (long) quotient;
        return quotient < whole ? whole - 1 : whole;
    }

    private int bucket(long x, long y, long z) {
        long hash = x * 73856093L ^ y * 19349663L ^ z * 83492791L;
        hash ^= hash >>> 32;
        hash ^= hash >>> 16;
        return (int) hash & bucketStart.length - 2;
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
        int count = 0;
        for (long x = cubes[3 * i] - 1; x <= cubes[3 * i] + 1; x++) {
            for (long y = cubes[3 * i + 1] - 1; y <= cubes[3 * i + 1] + 1; y++) {
                for (long z = cubes[3 * i + 2] - 1; z <= cubes[3 * i + 2] + 1; z++) {
                    int bucket = bucket(x, y, z);
                    for (int s = bucketStart[bucket]; s < bucketStart[bucket + 1]; s++) {
                        int j = sorted[s];
                        if (j > i && cubes[3 * j] == x && cubes[3 * j + 1] == y && cubes[3 * j + 2] == z) {
                            found[count++] = j;
                        }
                    }
                }
            }
        }
        return count;
    }
}
