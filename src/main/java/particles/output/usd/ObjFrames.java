package particles.output.usd;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.output.files.Numbers;
import particles.output.files.OutputFolder;
import particles.output.frames.MotionFile;
import particles.output.painters.FrameState;
import particles.output.painters.SurfacePainter.IntactTriangles;
import particles.view.Scenery.Surface;
import particles.view.SpringView.SpringList;

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
        SpringList springs = state.springs();
        String text = Stream.of(Stream.of("# t = " + Numbers.shortest(state.time()) + " s; unit: m\n"),
                IntStream.range(0, state.particles()).mapToObj(state::place).map(at -> "v " + Numbers.shortest(at.x())
                + " " + Numbers.shortest(at.y()) + " " + Numbers.shortest(at.z()) + "\n"),
                surfaces.stream().flatMap(surface -> elements("o surface\n", "f", surface.in(state), 3)),
                elements("o springs\n", "l", IntStream.range(0, springs.count()).flatMap(s ->
                IntStream.of(springs.from()[s], springs.to()[s])).toArray(), 2))
                .flatMap(part -> part).collect(Collectors.joining());
        folder.createFrame(frame, "obj").writeWhole(text.getBytes(StandardCharsets.UTF_8));
    }

    /** Elements of this many particles each. */
    private static Stream<String> elements(String name, String keyword, int[] particles, int each) {
        return IntStream.range(0, particles.length).mapToObj(c -> (c == 0 ? name : "") + (c % each == 0 ? keyword : "")
                + " " + (particles[c] + 1) + (c % each == each - 1 ? "\n" : ""));
    }
}
