package particles.output.usd;

import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.IntFunction;
import java.util.function.IntToDoubleFunction;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.law.Vector3;
import particles.output.files.Numbers;
import particles.output.files.OutputFolder;
import particles.output.frames.FrameRenderer.FrameSetup;
import particles.output.frames.MotionFile;
import particles.output.painters.DrawnSizes;
import particles.output.painters.FrameState;
import particles.output.painters.SurfacePainter.IntactTriangles;
import particles.output.painters.VisibilityFilter;
import particles.output.raster.CameraProjection;
import particles.view.Camera;
import particles.view.RenderOptions;
import particles.view.SpringView.SpringList;

/**
 * Writes {@code motion.usda}, a stage of Universal Scene Description that Blender, Maya, Houdini and others open. A
 * surface is a Mesh, all other particles are Points, and springs, rods and lines are BasisCurves. A time code is a
 * frame; lengths are in metres, and y points up. The ids of particles are in the primvar {@code name}; a particle's
 * number in {@code ids} never changes.
 *
 * <p>Source: Pixar, reference of UsdGeom, openusd.org.
 */
public final class UsdFile implements MotionFile {
    /** The file's name. */
    public static final String FILE = "motion.usda";
    private static final String NAMES = """
                    string[] primvars:name (
                        interpolation = "vertex"
                    )
            """;
    private static final String MESH = """
                def Mesh "surface%d"
                {
                    uniform token subdivisionScheme = "none"
                    bool doubleSided = true
                    color3f[] primvars:displayColor = [%s]
            """ + NAMES;
    private static final String BALLS = """
                def Points "particles"
                {
                    color3f[] primvars:displayColor (
                        interpolation = "vertex"
                    )
            """ + NAMES;
    private static final String CURVES = """
                def BasisCurves "springs"
                {
                    uniform token type = "linear"
            """ + NAMES;
    /** The height of a camera's film (mm), which is arbitrary; its width follows from the picture. */
    private static final double FILM = 20.25;
    /** The farthest and the nearest that the camera sees, relative to its distance from the target. */
    private static final double FAR = 1000;

    private final FrameSetup setup;
    private final double rate;
    private final UsdStage stage;
    private final CameraProjection view;
    private final VisibilityFilter shown;
    private final List<IntactTriangles> triangles;
    private final Map<String, Integer> numbers = new HashMap<>();
    private int born;
    private DrawnSizes sizes;
    private int first;
    private int now = -1;

    /**
     * Begins the file.
     *
     * @param setup  the settings of all frames
     * @param width  the width of pictures (pixels)
     * @param height the height of pictures (pixels)
     * @param rate   frames per second
     */
    public UsdFile(OutputFolder folder, FrameSetup setup, int width, int height, double rate) {
        this.setup = setup;
        this.rate = rate;
        stage = new UsdStage(folder, FILE);
        view = new CameraProjection(setup.camera(), width, height);
        shown = new VisibilityFilter(setup.look(), setup.scenery().surfaces());
        triangles = setup.scenery().surfaces().stream().map(IntactTriangles::new).toList();
    }

    @Override
    public void write(int frame, FrameState state) {
        if (now < 0) {
            first = frame;
            sizes = DrawnSizes.of(state, setup.look(), view.viewHeight);
        }
        now = frame;
        int[] inSurfaces = IntStream.range(0, triangles.size()).flatMap(k -> writeMesh(k, state)).sorted().toArray();
        writeBalls(state, IntStream.range(0, state.particles())
                .filter(i -> shown.particle(i) || Arrays.binarySearch(inSurfaces, i) < 0).toArray());
        SpringList springs = state.springs();
        int[] drawn = IntStream.range(0, springs.count())
                .filter(s -> shown.spring(springs.from()[s], springs.to()[s])).toArray();
        writePoints(CURVES, state, Arrays.stream(drawn)
                .flatMap(s -> IntStream.of(springs.from()[s], springs.to()[s])).toArray());
        put(CURVES, "int[] curveVertexCounts", drawn.length, k -> 2);
        writeWidths(CURVES, 2 * drawn.length, k -> sizes.tube(springs.stiffness()[drawn[k / 2]]));
    }

    /** Writes a surface, and returns its particles. */
    private IntStream writeMesh(int k, FrameState state) {
        String prim = MESH.formatted(k, colour(setup.look().colours().front()));
        int[] particles = Arrays.stream(setup.scenery().surfaces().get(k).triangles())
                .filter(i -> i < state.particles()).sorted().distinct().toArray();
        int[] corners = triangles.get(k).in(state);
        writePoints(prim, state, particles);
        put(prim, "int[] faceVertexCounts", corners.length / 3, t -> 3);
        put(prim, "int[] faceVertexIndices", corners.length, c -> Arrays.binarySearch(particles, corners[c]));
        return Arrays.stream(particles);
    }

    private void writeBalls(FrameState state, int[] balls) {
        List<String> ids = List.of(state.structure().ids());
        numbers.keySet().retainAll(Set.copyOf(ids));
        ids.forEach(id -> numbers.computeIfAbsent(id, key -> born++));
        RenderOptions.Colours colours = setup.look().colours();
        writePoints(BALLS, state, balls);
        writeWidths(BALLS, balls.length, k -> state.structure().radius(balls[k], sizes.ball()));
        put(BALLS, "int64[] ids", balls.length, k -> numbers.get(ids.get(balls[k])));
        put(BALLS, "color3f[] primvars:displayColor", balls.length, k -> colour(state.structure().colour(balls[k],
                state.isFixed(balls[k]) ? colours.fixed() : colours.particle())));
    }

    private void writePoints(String prim, FrameState state, int[] particles) {
        put(prim, UsdStage.POINTS, particles.length, k -> point(state.place(particles[k])));
        put(prim, "string[] primvars:name", particles.length, k -> quote(state.structure().ids()[particles[k]]));
    }

    private void writeWidths(String prim, int n, IntToDoubleFunction radius) {
        put(prim, "float[] widths", n, k -> number(2 * radius.applyAsDouble(k)));
    }

    private void put(String prim, String attribute, int n, IntFunction<Object> value) {
        stage.put(prim, attribute, now, IntStream.range(0, n).mapToObj(k -> value.apply(k).toString())
                .collect(Collectors.joining(", ", "[", "]")));
    }

    private static String quote(String text) {
        return '"' + text.replace("\\", "\\\\").replace("\"", "\\\"") + '"';
    }

    private static String number(double value) {
        return Numbers.shortest((float) value);
    }

    private static String point(Vector3 at) {
        return "(" + coordinates(at) + ")";
    }

    private static String coordinates(Vector3 at) {
        return number(at.x()) + ", " + number(at.y()) + ", " + number(at.z());
    }

    /** A colour of the screen as an amount of light. */
    private static String colour(int rgb) {
        double[] light = IntStream.of(16, 8, 0).mapToDouble(shift -> Math.pow((rgb >> shift & 255) / 255.0, 2.2))
                .toArray();
        return point(Vector3.at(light, 0));
    }

    @Override
    public void close() {
        Camera camera = setup.camera();
        double distance = camera.position().minus(camera.target()).length();
        // an orthographic camera's aperture is in tenths of a metre
        double film = camera.perspective() ? FILM : 10 * camera.height();
        try (stage) {
            stage.finish("""
                    #usda 1.0
                    (
                        defaultPrim = "scene"
                        doc = %s
                        metersPerUnit = 1
                        upAxis = "Y"
                        startTimeCode = %d
                        endTimeCode = %d
                        timeCodesPerSecond = %s
                        framesPerSecond = %4$s
                    )

                    def Xform "scene" (
                        kind = "component"
                    )
                    {
                        def Camera "camera"
                        {
                            token projection = "%s"
                            float focalLength = %s
                            float verticalAperture = %s
                            float horizontalAperture = %s
                            float2 clippingRange = (%s, %s)
                            matrix4d xformOp:transform = ((%s, 0), (%s, 0), (%s, 0), (%s, 1))
                            uniform token[] xformOpOrder = ["xformOp:transform"]
                        }
                    """.formatted(Stream.concat(Stream.of(quote(setup.title() + ": " + setup.caption()), first, now,
                    number(rate), camera.perspective() ? "perspective" : "orthographic",
                    number(FILM / 2 / Math.tan(Math.toRadians(camera.fieldOfView()) / 2)), number(film),
                    number(film * view.width / view.height), number(distance / FAR), number(distance * FAR)),
                    Stream.of(view.right, view.up, view.back, camera.position()).map(UsdFile::coordinates))
                    .toArray()));
        }
    }
}
