package particles.output.painters;

import com.carrotsearch.hppc.LongArrayList;
import com.carrotsearch.hppc.LongFloatHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import particles.law.Vector3;

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

    /** The nodes that the field reaches, in the order of the balls, so that pictures are the same in every run. */
    final LongArrayList nodes = new LongArrayList();
    private final LongFloatHashMap values = new LongFloatHashMap();
    /** The balls by cubes as wide as R: all those that reach a point are in its cube or the 26 around. */
    private final Map<Long, List<Vector3>> cubes;
    private final double reach;
    private final double cell;

    /**
     * @param radius the radius of a single ball (m)
     * @param balls  their middles (m); those far out of every picture do not count
     * @param finest the smallest useful cell (m)
     */
    BlobField(double radius, List<Vector3> balls, double finest) {
        reach = REACH * radius;
        double across = Math.cbrt(MOST_VISITS / Math.max(1, balls.size()));
        double fine = Math.max(radius / FINEST, Math.max(finest, 2 * reach / across));
        cell = Math.min(fine, 0.7 * radius);            // in a coarser grid a ball could fall between the nodes
        double far = (FARTHEST - 4) * cell - reach;
        List<Vector3> near = balls.stream().filter(ball -> Math.abs(ball.x()) < far && Math.abs(ball.y()) < far
                && Math.abs(ball.z()) < far).toList();
        cubes = near.stream().collect(Collectors.groupingBy(this::cube));
        near.forEach(this::add);
    }

    private void add(Vector3 ball) {
        int z0 = (int) Math.ceil((ball.z() - reach) / cell);
        int z1 = (int) Math.floor((ball.z() + reach) / cell);
        int y0 = (int) Math.ceil((ball.y() - reach) / cell);
        int y1 = (int) Math.floor((ball.y() + reach) / cell);
        int x1 = (int) Math.floor((ball.x() + reach) / cell);
        double square = reach * reach;
        for (int x = (int) Math.ceil((ball.x() - reach) / cell); x <= x1; x++) {
            double dx = x * cell - ball.x();
            for (int y = y0; y <= y1; y++) {
                double dy = y * cell - ball.y();
                for (int z = z0; z <= z1; z++) {
                    double dz = z * cell - ball.z();
                    double rest = 1 - (dx * dx + dy * dy + dz * dz) / square;
                    if (rest > 0) {
                        add(key(x, y, z), (float) (rest * rest * rest));
                    }
                }
            }
        }
    }

    private void add(long node, float value) {
        int before = values.size();
        values.addTo(node, value);
        if (values.size() > before) {
            nodes.add(node);
        }
    }

    private static long key(long x, long y, long z) {
        return (x + FARTHEST) * step(0) + (y + FARTHEST) * step(1) + z + FARTHEST;
    }

    private long cube(Vector3 point) {
        return key((long) Math.floor(point.x() / reach), (long) Math.floor(point.y() / reach),
                (long) Math.floor(point.z() / reach));
    }

    /**
     * Moves a point that is near the surface onto it, by one Newton step along the gradient of at most a cell.
     *
     * @return the unit normal there, outwards, and the point
     */
    Vector3[] onSurface(Vector3 point) {
        double value = 0;
        Vector3 outwards = Vector3.ZERO;                // the field decreases outwards: -R^2 / 6 of its gradient
        long own = cube(point);
        for (int k = 0; k < 27; k++) {
            long cube = own + (k / 9 - 1) * step(0) + (k / 3 % 3 - 1) * step(1) + k % 3 - 1;
            for (Vector3 ball : cubes.getOrDefault(cube, List.of())) {
                Vector3 from = point.minus(ball);
                double rest = Math.max(0, 1 - from.dot(from) / (reach * reach));
                value += rest * rest * rest;
                outwards = outwards.plus(from.times(rest * rest));
            }
        }
        double length = outwards.length();
        if (!(length > 0)) {
            return new Vector3[] {outwards, point};
        }
        Vector3 normal = outwards.times(1 / length);
        double way = (value - LEVEL) * reach * reach / (6 * length);
        return new Vector3[] {normal, point.plus(normal.times(Math.max(-cell, Math.min(cell, way))))};
    }

    /** @return the difference of neighbours along axis 0, 1 or 2 */
    static long step(int axis) {
        return 1L << 42 - 21 * axis;
    }

    /** @return where a node is (m) */
    Vector3 place(long node) {
        return new Vector3((node >> 42) - FARTHEST, (node >> 21 & 0x1fffff) - FARTHEST,
                (node & 0x1fffff) - FARTHEST).times(cell);
    }

    /** @return the field at a node */
    float value(long node) {
        return values.get(node);
    }
}
