package particles.output.painters;

import java.util.Optional;
import particles.law.Sphere;
import particles.law.Vector3;
import particles.output.raster.ShadowMap;
import particles.view.Scenery;
import particles.view.Surface;

/** Draws the shadows of a frame's shapes onto a plane's shadow map. */
public final class ShadowPainter {
    private final VisibilityFilter shown;
    private final DrawnSizes sizes;
    private final Scenery scenery;
    private final ParticlePainter particles;
    private final Optional<BlobSurface> blobs;
    private final Optional<WirePainter> wires;
    private double[] columns = {};
    private double[] rows = {};
    private boolean[] above = {};

    /**
     * @param shown     the filter of the things drawn
     * @param scenery   surfaces and spheres, always drawn
     * @param particles tells which particles are balls
     * @param blobs     the surface around the others, if there is one
     * @param wires     the painter of the wires
     */
    public ShadowPainter(VisibilityFilter shown, DrawnSizes sizes, Scenery scenery, ParticlePainter particles,
            Optional<BlobSurface> blobs,
                  Optional<WirePainter> wires) {
        this.shown = shown;
        this.sizes = sizes;
        this.scenery = scenery;
        this.particles = particles;
        this.blobs = blobs;
        this.wires = wires;
    }

    /** Adds the shadows of a frame to a map. */
    public void paint(ShadowMap map, FrameState state) {
        map.clear();
        project(map, state.positions, state.particles);
        for (int i = 0; i < state.particles; i++) {
            if (above[i] && particles.isBall(state, i)) {
                map.disc(columns[i], rows[i], particles.ball(state, i));
            } else if (above[i] && particles.isPoint(state, i)) {
                map.disc(columns[i], rows[i], particles.point());
            }
        }
        for (int s = 0; s < state.springs; s++) {
            int a = state.from[s];
            int b = state.to[s];
            if (above[a] && above[b] && shown.spring(a, b)) {
                double soft = sizes.isCoil(state, s) ? 0.5 * sizes.coil() : sizes.tube();
                map.strip(columns[a], rows[a], columns[b], rows[b], state.rigid[s] ? sizes.rod() : soft);
            }
        }
        for (Surface surface : scenery.surfaces()) {
            triangles(map, surface.triangles(), surface.triangles().length, state.particles);
        }
        for (Sphere sphere : scenery.spheres()) {
            Vector3 c = sphere.centre();
            if (!sphere.hollow() && map.isAbove(c.x(), c.y(), c.z())) {
                map.disc(map.column(c.x(), c.y(), c.z()), map.row(c.x(), c.y(), c.z()), sphere.radius());
            }
        }
        wires.ifPresent(painter -> painter.places().forEach(wire -> strips(map, wire, painter.getRadius())));
        blobs.ifPresent(surface -> {
            project(map, surface.places, surface.vertices);
            triangles(map, surface.corners, surface.cornerCount, surface.vertices);
        });
        map.blur();
    }

    private void strips(ShadowMap map, double[] wire, double radius) {
        project(map, wire, wire.length / 3);
        for (int k = 0; k + 1 < wire.length / 3; k++) {
            if (above[k] && above[k + 1]) {
                map.strip(columns[k], rows[k], columns[k + 1], rows[k + 1], radius);
            }
        }
    }

    private void project(ShadowMap map, double[] p, int n) {
        if (columns.length < n) {
            columns = new double[n];
            rows = new double[n];
            above = new boolean[n];
        }
        for (int i = 0; i < n; i++) {
            columns[i] = map.column(p[3 * i], p[3 * i + 1], p[3 * i + 2]);
            rows[i] = map.row(p[3 * i], p[3 * i + 1], p[3 * i + 2]);
            above[i] = map.isAbove(p[3 * i], p[3 * i + 1], p[3 * i + 2]);       // false for NaN
        }
    }

    private void triangles(ShadowMap map, int[] t, int length, int n) {
        for (int k = 0; k + 2 < length; k += 3) {
            if (t[k] < n && t[k + 1] < n && t[k + 2] < n && above[t[k]] && above[t[k + 1]] && above[t[k + 2]]) {
                map.triangle(columns[t[k]], rows[t[k]], columns[t[k + 1]], rows[t[k + 1]], columns[t[k + 2]],
                        rows[t[k + 2]]);
            }
        }
    }
}
