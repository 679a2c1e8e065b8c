package particles.output.painters;

import com.carrotsearch.hppc.LongArrayList;
import com.carrotsearch.hppc.LongIntHashMap;
import java.util.Arrays;

/**
 * The scalar field of metaballs on the nodes of a cubic grid: the sum of (1 - d&sup2;/R&sup2;)&sup3; over all balls
 * nearer than R. The surface is where it equals {@link #LEVEL}: a single ball is a sphere of radius R/2, and two merge
 * when they are less than 2.54 radii apart. (G. Wyvill, C. McPheeters, B. Wyvill, "Data structure for soft objects",
 * 1986, with an exponent of 3 in place of their sextic.)
 */
final class BlobField {
    /** R relative to the radius of a single ball. */
    private static final double REACH = 2;
    /** The field on the surface. */
    static final double LEVEL = Math.pow(1 - 1 / (REACH * REACH), 3);
    private static final int FARTHEST = 1 << 20;
    /** Cells per radius of a single ball, if that is not too many. */
    private static final double FINEST = 3.5;
    /** The largest number of ball-node contributions for one picture. */
    private static final double MOST_VISITS = 1.2e7;

    /** The keys of the nodes that the field reaches, and the number of each in this list. */
    final LongArrayList nodes = new LongArrayList();
    private final LongIntHashMap numbers = new LongIntHashMap();
    /** The field, and its gradient along x, y and z, by the nodes' numbers. */
    float[] sums = {};
    private double reach;
    private double cell;

    /**
     * Starts a new picture.
     *
     * @param radius the radius of a single ball (m)
     * @param balls  the number of balls
     * @param finest the smallest useful cell (m)
     */
    void clear(double radius, int balls, double finest) {
        nodes.clear();
        numbers.clear();
        reach = REACH * radius;
        double across = Math.cbrt(MOST_VISITS / Math.max(1, balls));
        cell = Math.max(radius / FINEST, Math.max(finest, 2 * reach / across));
        cell = Math.min(cell, 0.7 * radius);            // in a coarser grid a ball could fall between the nodes
    }

    /** @return the distance from node to node (m) */
    double getCellSize() {
        return cell;
    }

    /** @return the difference of the keys of neighbours along axis 0, 1 or 2 */
    static long step(int axis) {
        return 1L << 42 - 21 * axis;
    }

    /** @return the coordinate (m) along axis 0, 1 or 2 of a node with this key */
    double place(long key, int axis) {
        return ((key >> 42 - 21 * axis & 0x1fffff) - FARTHEST) * cell;
    }

    /** @return the field at a node */
    float value(long key) {
        int node = number(key);
        return node < 0 ? 0 : sums[4 * node];
    }

    /** @return the number of a node, -1 if the field does not reach it */
    int number(long key) {
        return numbers.getOrDefault(key, -1);
    }

    /** Adds a ball. */
    void add(double x, double y, double z) {
        double far = (FARTHEST - 4) * cell - reach;
        if (!(Math.abs(x) < far) || !(Math.abs(y) < far) || !(Math.abs(z) < far)) {
            return;                                     // out of every picture
        }
        int z0 = (int) Math.ceil((z - reach) / cell);
        int z1 = (int) Math.floor((z + reach) / cell);
        int y0 = (int) Math.ceil((y - reach) / cell);
        int y1 = (int) Math.floor((y + reach) / cell);
        int x1 = (int) Math.floor((x + reach) / cell);
        double square = reach * reach;
        for (int ix = (int) Math.ceil((x - reach) / cell); ix <= x1; ix++) {
            double dx = ix * cell - x;
            for (int iy = y0; iy <= y1; iy++) {
                double dy = iy * cell - y;
                for (int iz = z0; iz <= z1; iz++) {
                    double dz = iz * cell - z;
                    double rest = 1 - (dx * dx + dy * dy + dz * dz) / square;
                    if (rest > 0) {
                        add((ix + FARTHEST) * step(0) + (iy + FARTHEST) * step(1) + iz + FARTHEST, rest, dx, dy, dz);
                    }
                }
            }
        }
    }

    private void add(long key, double rest, double dx, double dy, double dz) {
        int node = numbers.getOrDefault(key, nodes.size());
        int at = 4 * node;
        if (node == nodes.size()) {
            nodes.add(key);
            numbers.put(key, node);
            if (at >= sums.length) {
                sums = Arrays.copyOf(sums, Math.max(1 << 14, 2 * sums.length));
            }
            Arrays.fill(sums, at, at + 4, 0);
        }
        double slope = -6 * rest * rest / (reach * reach);
        sums[at] += (float) (rest * rest * rest);
        sums[at + 1] += (float) (slope * dx);
        sums[at + 2] += (float) (slope * dy);
        sums[at + 3] += (float) (slope * dz);
    }
}
