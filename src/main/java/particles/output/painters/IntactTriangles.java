package particles.output.painters;

import java.util.Arrays;
import java.util.stream.IntStream;
import particles.view.Scenery.Surface;
import particles.view.SpringList;

/** Finds the intact triangles of a surface: in a tearing cloth, one with fewer than two spring edges left is torn. */
public final class IntactTriangles {
    private final Surface surface;
    private long[] springs = {};                        // sorted; in a large cloth, a set would take 80 bytes for each
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
