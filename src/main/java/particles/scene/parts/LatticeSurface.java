package particles.scene.parts;

import java.util.stream.IntStream;
import particles.view.Surface;

/** Makes the surface that a lattice spans: a cloth itself, or the six sides of a block. */
public record LatticeSurface(Lattice lattice, IntStream.Builder triangles) {
    /**
     * @param lattice   a lattice in two or three directions
     * @param first     the index of its first particle in the system
     * @param ofSprings whether springs connect neighbours along its directions
     * @return its surface
     */
    public static Surface of(Lattice lattice, int first, boolean ofSprings) {
        LatticeSurface surface = new LatticeSurface(lattice, IntStream.builder());
        if (lattice.counts().size() == 2) {
            surface.addSheet(first, 1, 0);                 // front: the viewer sees [0,0] top left
        } else {
            for (int d = 0; d < 3; d++) {
                surface.addSheet(first, (d + 2) % 3, (d + 1) % 3);
                surface.addSheet(first + (lattice.counts().get(d) - 1) * lattice.stride(d), (d + 1) % 3, (d + 2) % 3);
            }
        }
        return new Surface(surface.triangles.build().toArray(), ofSprings);
    }

    /** Adds the sheet through a corner along directions u and v; its front is on the side of u x v. */
    private void addSheet(int corner, int u, int v) {
        int right = lattice.stride(u);
        int down = lattice.stride(v);
        for (int i = 0; i + 1 < lattice.counts().get(u); i++) {
            for (int j = 0; j + 1 < lattice.counts().get(v); j++) {
                int a = corner + i * right + j * down;
                int c = a + right + down;
                IntStream.of(a, a + right, c, a, c, a + down).forEach(triangles);
            }
        }
    }
}
