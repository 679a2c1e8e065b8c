package particles.output.painters;

import java.util.Arrays;
import java.util.IdentityHashMap;
import java.util.Map;
import particles.output.raster.CameraProjection;
import particles.output.raster.Colours;
import particles.output.raster.Lighting;
import particles.output.raster.Raster;
import particles.view.RenderOptions;
import particles.view.Surface;

/**
 * Draws surfaces with Gouraud shading (1971) on both sides: light is computed at the particles with the mean normal of
 * the triangles around, and interpolated. A triangle that is bent far from that mean, as at an edge, uses its own
 * normal.
 */
public final class SurfacePainter {
    /** The cosine between a triangle's normal and a particle's from which the surface counts as smooth. */
    private static final int[] CORNERS = {0, 1, 2};
    private static final double SMOOTH = 0.85;

    private final Raster raster;
    private final CameraProjection view;
    private final Lighting lighting;
    private final RenderOptions look;
    private final Map<Surface, IntactTriangles> triangles = new IdentityHashMap<>();
    private double[] normals = {};
    private int[] front = {};
    private int[] back = {};
    private final double[] cornerX = new double[3];
    private final double[] cornerY = new double[3];
    private final double[] cornerNear = new double[3];
    private final int[] cornerColour = new int[3];
    private final double[] normal = new double[3];

    /** Creates a painter that draws onto this raster. */
    public SurfacePainter(Raster raster, CameraProjection view, Lighting lighting, RenderOptions look) {
        this.raster = raster;
        this.view = view;
        this.lighting = lighting;
        this.look = look;
    }

    /** Draws one surface. */
    public void paint(Surface surface, FrameState state, ProjectedParticles projected) {
        int n = state.particles;
        if (normals.length < 3 * n) {
            normals = new double[3 * n];
            front = new int[n];
            back = new int[n];
        }
        Arrays.fill(normals, 0, 3 * n, 0);
        int[] corners = surface.triangles();
        boolean[] whole = triangles.computeIfAbsent(surface, IntactTriangles::new).in(state);
        for (int t = 0; t + 2 < corners.length; t += 3) {
            if (whole[t / 3]) {
                computeNormal(state.positions, corners[t], corners[t + 1], corners[t + 2]);
                for (int c = t; c < t + 3; c++) {
                    for (int k = 0; k < 3; k++) {
                        normals[3 * corners[c] + k] += normal[k];     // weighted by area
                    }
                }
            }
        }
        for (int i = 0; i < n; i++) {
            shade(i);
        }
        for (int t = 0; t + 2 < corners.length; t += 3) {
            if (whole[t / 3]) {
                paint(corners, t, state, projected);
            }
        }
    }

    private void computeNormal(double[] p, int a, int b, int c) {
        double ux = p[3 * b] - p[3 * a];
        double uy = p[3 * b + 1] - p[3 * a + 1];
        double uz = p[3 * b + 2] - p[3 * a + 2];
        double vx = p[3 * c] - p[3 * a];
        double vy = p[3 * c + 1] - p[3 * a + 1];
        double vz = p[3 * c + 2] - p[3 * a + 2];
        normal[0] = uy * vz - uz * vy;
        normal[1] = uz * vx - ux * vz;
        normal[2] = ux * vy - uy * vx;
    }

    /** Normalises the normal and computes the colours of both sides. */
    private void shade(int i) {
        double x = normals[3 * i];
        double y = normals[3 * i + 1];
        double z = normals[3 * i + 2];
        double length = Math.sqrt(x * x + y * y + z * z);
        if (!(length > 0)) {
            return;
        }
        normals[3 * i] = x / length;
        normals[3 * i + 1] = y / length;
        normals[3 * i + 2] = z / length;
        front[i] = colour(x / length, y / length, z / length, look.colours().front());
        back[i] = colour(-x / length, -y / length, -z / length, look.colours().back());
    }

    private int colour(double x, double y, double z, int rgb) {
        float nx = (float) (x * view.right.x() + y * view.right.y() + z * view.right.z());
        float ny = (float) (x * view.up.x() + y * view.up.y() + z * view.up.z());
        float nz = (float) (x * view.back.x() + y * view.back.y() + z * view.back.z());
        return Colours.lit(rgb, lighting.light(nx, ny, nz), 0.35f * lighting.highlight(nx, ny, nz));
    }

    private void paint(int[] corners, int t, FrameState state, ProjectedParticles projected) {
        for (int k = 0; k < 3; k++) {
            int i = corners[t + k];
            if (!projected.visible[i]) {
                return;
            }
            cornerX[k] = projected.x[i];
            cornerY[k] = projected.y[i];
            cornerNear[k] = projected.near[i];
        }
        // y points down in the picture: counter-clockwise for the viewer is a negative area
        boolean front = (cornerX[1] - cornerX[0]) * (cornerY[2] - cornerY[0])
                - (cornerX[2] - cornerX[0]) * (cornerY[1] - cornerY[0]) < 0;
        computeNormal(state.positions, corners[t], corners[t + 1], corners[t + 2]);
        double length = Math.sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
        int flat = -1;
        for (int k = 0; k < 3; k++) {
            int i = corners[t + k];
            double cosine = (normal[0] * normals[3 * i] + normal[1] * normals[3 * i + 1]
                    + normal[2] * normals[3 * i + 2]) / length;
            if (cosine >= SMOOTH) {
                cornerColour[k] = front ? this.front[i] : back[i];
                continue;
            }
            if (flat < 0 && length > 0) {
                double side = (front ? 1 : -1) / length;
                flat = colour(side * normal[0], side * normal[1], side * normal[2],
                        front ? look.colours().front() : look.colours().back());
            }
            cornerColour[k] = Math.max(0, flat);
        }
        raster.triangle(CORNERS, 0, cornerX, cornerY, cornerNear, cornerColour);
    }
}
