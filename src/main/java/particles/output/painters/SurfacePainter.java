package particles.output.painters;

import java.util.Arrays;
import java.util.List;
import particles.law.Vector3;
import particles.output.raster.CameraProjection.Place;
import particles.output.raster.RoundShapes;
import particles.view.RenderOptions;

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
}
