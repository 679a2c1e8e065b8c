package particles.output.painters;

import java.util.Optional;
import particles.law.Sphere;
import particles.law.Vector3;
import particles.output.raster.ShadowMap;
import particles.view.Scenery;

/**
 * Draws the shadows of a frame's shapes onto a plane's shadow map.
 *
 * @param shown     the filter of the things drawn
 * @param sizes     the sizes of springs
 * @param scenery   surfaces and spheres, always drawn
 * @param particles tells which particles are balls
 * @param blobs     the surface around the others, if there is one
 * @param wires     the painter of the wires
 */
public record ShadowPainter(VisibilityFilter shown, DrawnSizes sizes, Scenery scenery, ParticlePainter particles,
        Optional<BlobSurface> blobs, Optional<WirePainter> wires) {
    /** Points projected onto the map, and whether they are on the plane's outer side. */
    private record Feet(ShadowMap map, double[] columns, double[] rows, boolean[] above) {
        static Feet of(ShadowMap map, double[] p, int n) {
            Feet feet = new Feet(map, new double[n], new double[n], new boolean[n]);
            for (int i = 0; i < n; i++) {
                feet.columns[i] = map.column(p[3 * i], p[3 * i + 1], p[3 * i + 2]);
                feet.rows[i] = map.row(p[3 * i], p[3 * i + 1], p[3 * i + 2]);
                feet.above[i] = map.isAbove(p[3 * i], p[3 * i + 1], p[3 * i + 2]);      // false for NaN
            }
            return feet;
        }

        void strip(int a, int b, double radius) {
            if (above[a] && above[b]) {
                map.strip(columns[a], rows[a], columns[b], rows[b], radius);
            }
        }

        void triangles(int[] t, int length) {
            int n = above.length;
            for (int k = 0; k + 2 < length; k += 3) {
                int a = t[k];
                int b = t[k + 1];
                int c = t[k + 2];
                if (Math.max(a, Math.max(b, c)) < n && above[a] && above[b] && above[c]) {
                    map.triangle(columns[a], rows[a], columns[b], rows[b], columns[c], rows[c]);
                }
            }
        }
    }

    /** Adds the shadows of a frame to a map. */
    public void paint(ShadowMap map, FrameState state) {
        map.clear();
        Feet feet = Feet.of(map, state.positions, state.particles);
        for (int i = 0; i < state.particles; i++) {
            boolean ball = particles.isBall(state, i);
            if (feet.above[i] && (ball || particles.isPoint(state, i))) {
                map.disc(feet.columns[i], feet.rows[i], ball ? particles.ball(state, i) : particles.point());
            }
        }
        for (int s = 0; s < state.springs; s++) {
            if (shown.spring(state.from[s], state.to[s])) {
                feet.strip(state.from[s], state.to[s], state.isRigid(s) ? sizes.rod()
                        : sizes.isCoil(state, s) ? 0.5 * sizes.coil() : sizes.tube());
            }
        }
        scenery.surfaces().forEach(surface -> feet.triangles(surface.triangles(), surface.triangles().length));
        for (Sphere sphere : scenery.spheres()) {
            Vector3 c = sphere.centre();
            if (!sphere.hollow() && map.isAbove(c.x(), c.y(), c.z())) {
                map.disc(map.column(c.x(), c.y(), c.z()), map.row(c.x(), c.y(), c.z()), sphere.radius());
            }
        }
        wires.ifPresent(painter -> painter.places().forEach(places -> {
            Feet wire = Feet.of(map, places, places.length / 3);
            for (int k = 0; k + 1 < wire.above.length; k++) {
                wire.strip(k, k + 1, painter.getRadius());
            }
        }));
        blobs.ifPresent(surface ->
                Feet.of(map, surface.places, surface.vertices).triangles(surface.corners, surface.cornerCount));
        map.blur();
    }
}
