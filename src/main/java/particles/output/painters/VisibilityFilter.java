package particles.output.painters;

import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.stream.IntStream;
import particles.view.RenderOptions;
import particles.view.RenderOptions.Visibility;
import particles.view.Scenery.Surface;

/**
 * Decides which particles and springs are drawn: those of a surface can be left out, and with a closed surface such as
 * a jelly's also the springs that begin on it.
 */
public final class VisibilityFilter {
    private final RenderOptions look;
    private final BitSet inSurface = new BitSet();
    private final BitSet onClosed = new BitSet();

    /** Creates a filter for these options and surfaces. */
    public VisibilityFilter(RenderOptions look, List<Surface> surfaces) {
        this.look = look;
        for (Surface surface : surfaces) {
            Arrays.stream(surface.triangles()).forEach(inSurface::set);
            if (isClosed(surface)) {
                Arrays.stream(surface.triangles()).forEach(onClosed::set);
            }
        }
    }

    /**
     * Whether a surface is closed: each edge of a triangle is also an edge of another one, in the opposite direction.
     */
    private static boolean isClosed(Surface surface) {
        return Arrays.equals(edges(surface.triangles(), true), edges(surface.triangles(), false));
    }

    /** All edges in order, from each corner to the next one of its triangle, or reversed. */
    private static long[] edges(int[] t, boolean forwards) {
        return IntStream.range(0, t.length).mapToLong(k -> {
            long a = t[k];
            long b = t[k % 3 == 2 ? k - 2 : k + 1];
            return forwards ? a << 32 | b : b << 32 | a;
        }).sorted().toArray();
    }

    /** @return whether particle i is drawn */
    public boolean particle(int i) {
        return look.particles() == Visibility.ALWAYS
                || look.particles() == Visibility.BESIDE_SURFACES && !inSurface.get(i);
    }

    /** @return whether a spring between these particles is drawn */
    public boolean spring(int from, int to) {
        return look.springs() == Visibility.ALWAYS
                || look.springs() == Visibility.BESIDE_SURFACES && !(inSurface.get(from) && inSurface.get(to))
                && !onClosed.get(from) && !onClosed.get(to);
    }
}
