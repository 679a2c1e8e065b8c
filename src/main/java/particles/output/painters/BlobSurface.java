package particles.output.painters;

import com.carrotsearch.hppc.LongIntHashMap;
import java.util.Arrays;

/**
 * Triangulates an isosurface by surface nets (S. Gibson, "Constrained elastic surface nets", 1998): each grid cell
 * crossed by the surface has one vertex, the mean of the edge crossings moved onto the surface, and each crossed edge
 * joins the four cells around it. The surface is closed except where it is cut off far away.
 */
final class BlobSurface {
    private final LongIntHashMap cells = new LongIntHashMap();
    /** The sum of edge crossings and their number. */
    private final double[] crossing = new double[4];
    private final double[] offset = new double[3];
    private BlobField field;
    /** The number of vertices. */
    int vertices;
    /** Three coordinates a vertex (m). */
    double[] places = {};
    /** The unit normals, outwards. */
    float[] normals = {};
    /** The number of entries of {@link #corners} in use. */
    int cornerCount;
    /** The vertices of the triangles: three a triangle, counter-clockwise seen from outside. */
    int[] corners = {};

    /** Builds the triangles of a field's surface. */
    void build(BlobField built) {
        field = built;
        cells.clear();
        vertices = 0;
        cornerCount = 0;
        for (int node = 0; node < field.nodes.size(); node++) {
            long key = field.nodes.get(node);
            if (isInside(key)) {
                for (int axis = 0; axis < 3; axis++) {
                    long step = BlobField.step(axis);
                    if (!isInside(key + step)) {
                        join(key, axis, true);
                    }
                    if (!isInside(key - step)) {
                        join(key - step, axis, false);
                    }
                }
            }
        }
    }

    private boolean isInside(long key) {
        return field.value(key) >= BlobField.LEVEL;
    }

    /**
     * The four cells around an edge, as two triangles: counter-clockwise seen from the edge's far end if that is
     * outside.
     */
    private void join(long edge, int axis, boolean outwards) {
        long b = BlobField.step((axis + 1) % 3);
        long c = BlobField.step((axis + 2) % 3);
        int first = vertex(edge);
        int second = vertex(edge - b);
        int third = vertex(edge - b - c);
        int fourth = vertex(edge - c);
        if (cornerCount + 6 > corners.length) {
            corners = Arrays.copyOf(corners, Math.max(1 << 12, 2 * corners.length));
        }
        int[] quad = outwards ? new int[] {first, second, third, fourth} : new int[] {fourth, third, second, first};
        for (int k : new int[] {0, 1, 2, 0, 2, 3}) {
            corners[cornerCount++] = quad[k];
        }
    }

    /** The vertex of the cell whose lowest corner has this key. */
    private int vertex(long cell) {
        int vertex = cells.getOrDefault(cell, vertices);
        if (vertex < vertices) {
            return vertex;
        }
        cells.put(cell, vertices++);
        if (3 * vertices > places.length) {
            int length = Math.max(1 << 12, 2 * places.length);
            places = Arrays.copyOf(places, length);
            normals = Arrays.copyOf(normals, length);
        }
        Arrays.fill(crossing, 0);
        for (int axis = 0; axis < 3; axis++) {
            long b = BlobField.step((axis + 1) % 3);
            long c = BlobField.step((axis + 2) % 3);
            cross(cell, axis);
            cross(cell + b, axis);
            cross(cell + c, axis);
            cross(cell + b + c, axis);
        }
        place(cell, vertex);
        return vertex;
    }

    /**
     * Moves the mean of the crossings, which lies inside a round surface, by one Newton step along the gradient. The
     * field there is the mean of two estimates from the cell's corners with weights w of linear interpolation, sum w f
     * and sum w (f + grad f . d), d from the corner to the point, whose second-order errors are opposite.
     */
    private void place(long cell, int vertex) {
        double share = 1 / crossing[3];
        double f = 0;
        double gx = 0;
        double gy = 0;
        double gz = 0;
        for (int corner = 0; corner < 8; corner++) {
            double weight = 1;
            long key = cell;
            for (int axis = 0; axis < 3; axis++) {
                double part = (crossing[axis] * share - field.place(cell, axis)) / field.getCellSize();
                boolean far = (corner >> axis & 1) == 1;
                key += far ? BlobField.step(axis) : 0;
                offset[axis] = (far ? part - 1 : part) * field.getCellSize();
                weight *= far ? part : 1 - part;
            }
            int at = 4 * field.number(key);
            if (at >= 0) {
                float[] sums = field.sums;
                f += weight * (sums[at] + (sums[at + 1] * offset[0] + sums[at + 2] * offset[1]
                        + sums[at + 3] * offset[2]) / 2);
                gx += weight * sums[at + 1];
                gy += weight * sums[at + 2];
                gz += weight * sums[at + 3];
            }
        }
        double length = Math.sqrt(gx * gx + gy * gy + gz * gz);
        double way = length > 0 ? (BlobField.LEVEL - f) / length : 0;
        way = Math.max(-field.getCellSize(), Math.min(field.getCellSize(), way));
        double scale = length > 0 ? 1 / length : 0;
        offset[0] = gx * scale;
        offset[1] = gy * scale;
        offset[2] = gz * scale;
        for (int k = 0; k < 3; k++) {
            places[3 * vertex + k] = crossing[k] * share + way * offset[k];
            normals[3 * vertex + k] = (float) -offset[k];           // the field decreases outwards
        }
    }

    /** Adds the point where the surface crosses an edge, if it does, and counts it. */
    private void cross(long key, int axis) {
        double low = field.value(key);
        double high = field.value(key + BlobField.step(axis));
        if (low >= BlobField.LEVEL == high >= BlobField.LEVEL) {
            return;
        }
        double part = (BlobField.LEVEL - low) / (high - low);
        for (int k = 0; k < 3; k++) {
            crossing[k] += field.place(key, k) + (k == axis ? part * field.getCellSize() : 0);
        }
        crossing[3]++;
    }
}
