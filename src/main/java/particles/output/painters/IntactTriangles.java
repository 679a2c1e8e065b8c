package particles.output.painters;

import java.util.Arrays;
import java.util.stream.IntStream;
import particles.view.SpringList;
import particles.view.Surface;

/** Finds the intact triangles of a surface: in a tearing cloth, one with fewer than two spring edges left is torn. */
public final class IntactTriangles {
    private final Surface surface;
    private long[] springs = {};                        // sorted; in a large cloth, a set would take 80 bytes for each
    private final boolean[] whole;
    private FrameStructure structure;

    /** Creates a search for the triangles of this surface. */
    public IntactTriangles(Surface surface) {
        this.surface = surface;
        whole = new boolean[surface.triangles().length / 3];
    }

    /** @return the corners of all triangles, whole or not */
    int[] getCorners() {
        return surface.triangles();
    }

    /** @return for each triangle whether it is drawn; valid until springs change */
    public boolean[] in(FrameState state) {
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
        for (int t = 0; t < whole.length; t++) {
            int a = corners[3 * t];
            int b = corners[3 * t + 1];
            int c = corners[3 * t + 2];
            boolean there = Math.max(a, Math.max(b, c)) < particles;      // particles may have been removed
            whole[t] = there && (!surface.ofSprings() || edge(a, b) + edge(b, c) + edge(c, a) >= 2);
        }
    }

    private int edge(int a, int b) {
        return Arrays.binarySearch(springs, pair(a, b)) >= 0 ? 1 : 0;
    }

    private static long pair(int a, int b) {
        return (long) Math.min(a, b) << 32 | Math.max(a, b);
    }
}
