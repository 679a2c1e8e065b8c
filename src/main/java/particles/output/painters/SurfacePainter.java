package particles.output.painters;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import particles.law.Vector3;
import particles.output.painters.FrameState.FrameStructure;
import particles.output.raster.CameraProjection.Place;
import particles.output.raster.RoundShapes;
import particles.view.RenderOptions;
import particles.view.Scenery.Surface;
import particles.view.SpringView.SpringList;

/**
 * Draws surfaces with Gouraud shading (1971) on both sides: light is computed at the particles with the mean normal of
 * the triangles around, and interpolated. A triangle that is bent far from that mean, as at an edge, uses its own
 * normal.
 */
public record SurfacePainter(RoundShapes shapes, RenderOptions look, List<IntactTriangles> surfaces) {
    /** The cosine between a triangle's normal and a particle's from which the surface counts as smooth. */
    private static final double SMOOTH = 0.85;

    /** Draws all surfaces. */
    void paint(FrameState state, Place[] places) {
        surfaces.forEach(surface -> paint(surface, state, places));
    }

    private void paint(IntactTriangles surface, FrameState state, Place[] places) {
        Vector3[] normals = new Vector3[state.particles()];
        Arrays.fill(normals, Vector3.ZERO);
        int[] corners = surface.in(state);
        for (int t = 0; t < corners.length; t += 3) {
            Vector3 normal = normal(state, corners, t);
            for (int c = t; c < t + 3; c++) {
                normals[corners[c]] = normals[corners[c]].plus(normal);     // weighted by area
            }
        }
        Arrays.setAll(normals, i -> unit(normals[i]));
        int[] colours = new int[normals.length];
        for (int t = 0; t < corners.length; t += 3) {
            shade(corners, t, isFront(corners, t, places), normal(state, corners, t), normals, colours);
            shapes.raster().triangle(corners, t, places, colours);
        }
    }

    private static Vector3 normal(FrameState state, int[] corners, int t) {
        Vector3 a = state.place(corners[t]);
        return state.place(corners[t + 1]).minus(a).cross(state.place(corners[t + 2]).minus(a));
    }

    private static Vector3 unit(Vector3 v) {
        return v.length() > 0 ? v.normalized() : Vector3.ZERO;
    }

    /** Whether the viewer sees the front; y points down in the picture, so counter-clockwise is a negative area. */
    private static boolean isFront(int[] corners, int t, Place[] places) {
        Place a = places[corners[t]];
        Place b = places[corners[t + 1]];
        Place c = places[corners[t + 2]];
        return (b.x() - a.x()) * (c.y() - a.y()) - (c.x() - a.x()) * (b.y() - a.y()) < 0;
    }

    /** Computes the colours of a triangle's corners. */
    private void shade(int[] corners, int t, boolean front, Vector3 normal, Vector3[] normals, int[] colours) {
        Vector3 own = unit(normal);
        for (int c = t; c < t + 3; c++) {
            Vector3 smooth = normals[corners[c]];
            Vector3 used = own.dot(smooth) >= SMOOTH ? smooth : own;
            colours[corners[c]] = shapes.lighting().shade(front ? look.colours().front() : look.colours().back(),
                    shapes.view().turned(front ? used : used.times(-1)), 0.35f);
        }
    }

    /**
     * Finds the intact triangles of a surface: in a tearing cloth, one with fewer than two spring edges left is torn.
     */
    public static final class IntactTriangles {
        private final Surface surface;
        private long[] springs = {};                    // sorted; in a large cloth, a set would take 80 bytes for each
        private int[] whole = {};
        private FrameStructure structure;

        /** Creates a search for the triangles of this surface. */
        public IntactTriangles(Surface surface) {
            this.surface = surface;
        }

        /** @return the corners of the triangles that are drawn, three each; valid until springs change */
        public int[] in(FrameState state) {
            if (structure != state.structure()) {
                structure = state.structure();
                find(structure.springs(), structure.ids().length);
            }
            return whole;
        }

        private void find(SpringList list, int particles) {
            springs = IntStream.range(0, surface.ofSprings() ? list.count() : 0)
                    .mapToLong(s -> pair(list.from()[s], list.to()[s])).sorted().toArray();
            int[] corners = surface.triangles();
            whole = IntStream.iterate(0, t -> t < corners.length, t -> t + 3)
                    .filter(t -> isWhole(corners[t], corners[t + 1], corners[t + 2], particles))
                    .flatMap(t -> Arrays.stream(corners, t, t + 3)).toArray();
        }

        private boolean isWhole(int a, int b, int c, int particles) {
            return Math.max(a, Math.max(b, c)) < particles         // some may have been removed
                    && (!surface.ofSprings() || edge(a, b) + edge(b, c) + edge(c, a) >= 2);
        }

        private int edge(int a, int b) {
            return Arrays.binarySearch(springs, pair(a, b)) >= 0 ? 1 : 0;
        }

        private static long pair(int a, int b) {
            return (long) Math.min(a, b) << 32 | Math.max(a, b);
        }
    }
}
