package particles.output.usd;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import particles.law.Vector3;
import particles.output.files.Numbers;
import particles.output.files.OutputFolder;
import particles.output.painters.FrameState;
import particles.output.painters.SurfacePainter.IntactTriangles;
import particles.view.Scenery.Surface;

/**
 * Writes one Wavefront OBJ file per frame, {@code frames/frame-00000.obj} and so on: vertex n + 1 is particle n,
 * surfaces are faces, and springs and rods are lines.
 */
public final class ObjFrames implements MotionFile {
    private final OutputFolder folder;
    private final List<IntactTriangles> surfaces;

    /** @param surfaces the surfaces that particles span */
    public ObjFrames(OutputFolder folder, List<Surface> surfaces) {
        this.folder = folder;
        this.surfaces = surfaces.stream().map(IntactTriangles::new).toList();
    }

    @Override
    public void write(int frame, FrameState state) {
        StringBuilder text = new StringBuilder("# t = " + Numbers.shortest(state.time()) + " s; unit: m\n");
        for (int i = 0; i < state.particles(); i++) {
            Vector3 at = state.place(i);
            text.append("v ").append(Numbers.shortest(at.x())).append(' ').append(Numbers.shortest(at.y())).append(' ')
                    .append(Numbers.shortest(at.z())).append('\n');
        }
        surfaces.forEach(surface -> append(text, "o surface\n", "f", surface.in(state), 3));
        int[] ends = IntStream.range(0, state.springs().count()).flatMap(s -> IntStream.of(state.springs().from()[s],
                state.springs().to()[s])).toArray();
        append(text, "o springs\n", "l", ends, 2);
        folder.createFrame(frame, "obj").writeWhole(text.toString().getBytes(StandardCharsets.UTF_8));
    }

    /** Appends elements of this many particles each. */
    private static void append(StringBuilder text, String name, String keyword, int[] particles, int each) {
        text.append(particles.length == 0 ? "" : name);
        for (int k = 0; k < particles.length; k += each) {
            text.append(IntStream.range(k, k + each).mapToObj(c -> " " + (particles[c] + 1))
                    .collect(Collectors.joining("", keyword, "\n")));
        }
    }
}
