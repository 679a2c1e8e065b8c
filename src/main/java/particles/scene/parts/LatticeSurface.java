package particles.scene.parts;

import particles.view.Surface;

/** The surface that a lattice spans: a cloth itself, or the six sides of a block. */
public final class LatticeSurface {
    private final int first;
    private final int[] counts;
    private final int[] strides;
    private final int[] triangles;
    private int filled;

    private LatticeSurface(Lattice lattice, int first) {
        this.first = first;
        counts = lattice.counts().stream().mapToInt(Integer::intValue).toArray();
        strides = lattice.strides();
        int squares = 0;
        for (int u = 0; u < counts.length; u++) {
            for (int v = u + 1; v < counts.length; v++) {
                squares += (counts[u] - 1) * (counts[v] - 1) * (counts.length - 1);
            }
        }
        triangles = new int[6 * squares];
    }

    /**
     * @param lattice a lattice of two or three directions
     * @param first   the index of its first particle in the system
     * @param ofSprings whether springs connect neighbours along its directions
     * @return its surface
     */
    public static Surface of(Lattice lattice, int first, boolean ofSprings) {
        LatticeSurface surface = new LatticeSurface(lattice, first);
        if (surface.counts.length == 2) {
            surface.addSheet(0, 1, 0);                  // front: the viewer sees [0,0] top left
        } else {
            for (int d = 0; d < 3; d++) {
                surface.addSheet(0, (d + 2) % 3, (d + 1) % 3);
                surface.addSheet((surface.counts[d] - 1) * surface.strides[d], (d + 1) % 3, (d + 2) % 3);
            }
        }
        return new Surface(surface.triangles, ofSprings);
    }

    /** Adds the sheet through a corner along directions u and v; its front is on the side of u x v. */
    private void addSheet(int corner, int u, int v) {
        for (int i = 0; i + 1 < counts[u]; i++) {
            for (int j = 0; j + 1 < counts[v]; j++) {
                int a = first + corner + i * strides[u] + j * strides[v];
                int b = a + strides[u];
                int c = b + strides[v];
                int d = a + strides[v];
                add(a, b, c);
                add(a, c, d);
            }
        }
    }

    private void add(int a, int b, int c) {
        triangles[filled++] = a;
        triangles[filled++] = b;
        triangles[filled++] = c;
    }
}
