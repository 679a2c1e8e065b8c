package particles.scene.parts;

import java.util.List;
import java.util.stream.IntStream;
import particles.view.Surface;

/** Makes the surface that a lattice spans: a cloth itself, or the six sides of a block. */
record LatticeSurface(List<Integer> counts, int[] strides, IntStream.Builder triangles) {
    /** As {@link Lattice#surface}, of a lattice. */
    static Surface of(Lattice lattice, int first, boolean ofSprings) {
        LatticeSurface surface = new LatticeSurface(lattice.counts(), lattice.strides(), IntStream.builder());
        if (surface.counts.size() == 2) {
            surface.addSheet(first, 1, 0);                 // front: the viewer sees [0,0] top left
        } else {
            for (int d = 0; d < 3; d++) {
                surface.addSheet(first, (d + 2) % 3, (d + 1) % 3);
                surface.addSheet(first + (surface.counts.get(d) - 1) * surface.strides[d], (d + 1) % 3, (d + 2) % 3);
            }
        }
        return new Surface(surface.triangles.build().toArray(), ofSprings);
    }

    /** Adds the sheet through a corner along directions u and v; its front is on the side of u x v. */
    private void addSheet(int corner, int u, int v) {
        for (int i = 0; i + 1 < counts.get(u); i++) {
            for (int j = 0; j + 1 < counts.get(v); j++) {
                int a = corner + i * strides[u] + j * strides[v];
                int b = a + strides[u];
                int c = b + strides[v];
                int d = a + strides[v];
                IntStream.of(a, b, c, a, c, d).forEach(triangles);
            }
        }
    }
}
