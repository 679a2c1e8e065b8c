package particles.output.painters;

import com.carrotsearch.hppc.IntArrayList;
import com.carrotsearch.hppc.LongIntHashMap;
import java.util.ArrayList;
import java.util.List;
import particles.law.Vector3;

/**
 * Triangulates an isosurface by surface nets (S. Gibson, "Constrained elastic surface nets", 1998): each grid cell
 * crossed by the surface has one vertex, the mean of the edge crossings moved onto the surface, and each crossed edge
 * joins the four cells around it. The surface is closed except where it is cut off far away.
 */
final class BlobSurface {
    private final BlobField field;
    private final LongIntHashMap cells = new LongIntHashMap();
    /** The vertices (m). */
    final List<Vector3> vertices = new ArrayList<>();
    /** Their unit normals, outwards. */
    final List<Vector3> normals = new ArrayList<>();
    /** The vertices of the triangles: three a triangle, counter-clockwise seen from outside. */
    final IntArrayList corners = new IntArrayList();

    /** Builds the triangles of a field's surface. */
    BlobSurface(BlobField field) {
        this.field = field;
        for (int node = 0; node < field.nodes.size(); node++) {
            long key = field.nodes.get(node);
            if (isInside(key)) {
                joinAround(key);
            }
        }
    }

    private void joinAround(long inside) {
        for (int axis = 0; axis < 3; axis++) {
            long step = BlobField.step(axis);
            if (!isInside(inside + step)) {
                join(inside, axis, true);
            }
            if (!isInside(inside - step)) {
                join(inside - step, axis, false);
            }
        }
    }

    private boolean isInside(long node) {
        return field.value(node) >= BlobField.LEVEL;
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
        int[] quad = outwards ? new int[] {first, second, third, fourth} : new int[] {fourth, third, second, first};
        corners.add(quad[0], quad[1], quad[2], quad[0], quad[2], quad[3]);
    }

    /** The vertex of the cell whose lowest corner is this node. */
    private int vertex(long cell) {
        int vertex = cells.getOrDefault(cell, vertices.size());
        if (vertex == vertices.size()) {
            cells.put(cell, vertex);
            Vector3[] moved = field.onSurface(middle(cell));        // the mean lies inside a round surface
            normals.add(moved[0]);
            vertices.add(moved[1]);
        }
        return vertex;
    }

    /** The mean of the points where the surface crosses the cell's edges. */
    private Vector3 middle(long cell) {
        Vector3 sum = Vector3.ZERO;
        int crossings = 0;
        for (int axis = 0; axis < 3; axis++) {
            long b = BlobField.step((axis + 1) % 3);
            long c = BlobField.step((axis + 2) % 3);
            for (long from : new long[] {cell, cell + b, cell + c, cell + b + c}) {
                double low = field.value(from);
                double high = field.value(from + BlobField.step(axis));
                if (low >= BlobField.LEVEL != high >= BlobField.LEVEL) {
                    double part = (BlobField.LEVEL - low) / (high - low);
                    sum = sum.plus(field.place(from).times(1 - part))
                            .plus(field.place(from + BlobField.step(axis)).times(part));
                    crossings++;
                }
            }
        }
        return sum.times(1.0 / crossings);
    }
}
