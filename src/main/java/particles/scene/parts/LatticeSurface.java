package particles.scene.parts;

import java.util.stream.IntStream;
import particles.view.Surface;

/** The surface that a lattice spans: a cloth itself, or the six sides of a block. */
public final class LatticeSurface {
    private final int[] counts;
    private final int[] strides;
    private final IntStream.Builder triangles = IntStream.builder();

    private LatticeSurface(Lattice lattice) {
        counts = lattice.counts().stream().mapToInt(Integer::intValue).toArray();
        strides = lattice.strides();
    }

    /**
     * @param lattice a lattice of two or three directions
     * @param first   the index of its first particle in the system
     * @param ofSprings whether springs connect neighbours along its directions
     * @return its surface
     */
    public static Surface of(Lattice lattice, int first, boolean ofSprings) {
        LatticeSurface surface = new LatticeSurface(lattice);
        if (surface.counts.length == 2) {
            surface.addSheet(first, 1, 0);                 // front: the viewer sees [0,0] top left
        } else {
            for (int d = 0; d < 3; d++) {
                surface.addSheet(first, (d + 2) % 3, (d + 1) % 3);
                surface.addSheet(first + (surface.counts[d] - 1) * surface.strides[d], (d + 1) % 3,
                        (d + 2) % 3);
            }
        }
        return new Surface(surface.triangles.build().toArray(), ofSprings);
    }

    /** Adds the sheet through a corner along directions u and v; its front is on the side of u x v. */
    private void addSheet(int corner, int u, int v) {
        for (int i = 0; i + 1 < counts[u]; i++) {
            for (int j = 0; j + 1 < counts[v]; j++) {
                int a = corner + i * strides[u] + j * strides[v];
                int b = a + strides[u];
                int c = b + strides[v];
                int d = a + strides[v];
                for (int vertex : new int[] {a, b, c, a, c, d}) {
                    triangles.add(vertex);
                }
            }
        }
    }
}
