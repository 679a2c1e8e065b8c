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
import particles.law.Particles;
import particles.law.Vector3;
import particles.output.files.Numbers;
import particles.output.files.OutputFolder;
import particles.output.painters.DrawnSizes;
import particles.output.painters.FrameState;
import particles.output.painters.SurfacePainter.IntactTriangles;
import particles.output.painters.VisibilityFilter;
import particles.output.raster.CameraProjection;
import particles.view.Camera;
import particles.view.RenderOptions;
import particles.view.Scenery;
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
    private static final String OF_EACH = " (\n            interpolation = \"vertex\"\n        )";
    /** The height of a camera's film (mm), which is arbitrary; its width follows from the picture. */
    private static final double FILM = 20.25;
    /** The farthest and the nearest that the camera sees, relative to its distance from the target. */
    private static final double FAR = 1000;
    private static final String COLOUR = "color3f[] primvars:displayColor";

    private final Setup setup;
    private final UsdStage stage;
    private final CameraProjection view;
    private final VisibilityFilter shown;
    private final List<IntactTriangles> surfaces;
    private final Map<String, Integer> numbers = new HashMap<>();
    private int born;
    private DrawnSizes sizes;
    private int first;
    private int now = -1;

    /**
     * What does not change in a run.
     *
     * @param title   what the stage shows
     * @param camera  the camera
     * @param width   the width of pictures (pixels)
     * @param height  the height of pictures (pixels)
     * @param rate    frames per second
     * @param look    the render options
     * @param scenery surfaces and lines
     */
    public record Setup(String title, Camera camera, int width, int height, double rate, RenderOptions look,
            Scenery scenery) {
    }

    /** Begins the file. */
    public UsdFile(OutputFolder folder, Setup setup) {
        this.setup = setup;
        stage = new UsdStage(folder, FILE);
        view = new CameraProjection(setup.camera, setup.width, setup.height);
        shown = new VisibilityFilter(setup.look, setup.scenery.surfaces());
        surfaces = setup.scenery.surfaces().stream().map(IntactTriangles::new).toList();
    }

    @Override
    public void write(int frame, FrameState state) {
        if (now < 0) {
            first = frame;
            sizes = DrawnSizes.of(state, setup.look, view.viewHeight);
        }
        now = frame;
        List<String> ids = List.of(state.structure().ids());
        numbers.keySet().retainAll(Set.copyOf(ids));
        ids.forEach(id -> numbers.computeIfAbsent(id, key -> born++));
        int[] inSurfaces = IntStream.range(0, surfaces.size()).flatMap(k -> writeMesh(k, state)).sorted().toArray();
        int[] free = IntStream.range(0, ids.size())
                .filter(i -> shown.particle(i) || Arrays.binarySearch(inSurfaces, i) < 0).toArray();
        RenderOptions.Colours colours = setup.look.colours();
        String balls = "Points \"particles\"";
        writePoints(balls, state, free, k -> state.structure().radius(free[k], sizes.ball()));
        put(balls, "int64[] ids", "", free.length, k -> numbers.get(ids.get(free[k])));
        put(balls, COLOUR, OF_EACH, free.length, k -> colour(state.structure().colour(free[k],
                state.isFixed(free[k]) ? colours.fixed() : colours.particle())));
        writeCurves("springs", state, sizes.tube(), ends(state, false));
        writeCurves("rods", state, sizes.rod(), ends(state, true));
        Map<String, Integer> index = new HashMap<>();
        ids.forEach(id -> index.put(id, index.size()));
        writeCurves("lines", state, sizes.railing(), setup.scenery.lines().stream().filter(line ->
                index.keySet().containsAll(List.of(line.from(), line.to()))).flatMapToInt(line ->
                IntStream.of(index.get(line.from()), index.get(line.to()))).toArray());
    }

    private int[] ends(FrameState state, boolean rigid) {
        SpringList springs = state.springs();
        return IntStream.range(0, springs.count()).filter(s -> springs.isRigid(s) == rigid
                && shown.spring(springs.from()[s], springs.to()[s]))
                .flatMap(s -> IntStream.of(springs.from()[s], springs.to()[s])).toArray();
    }

    /** Writes a surface, and returns its particles. */
    private IntStream writeMesh(int k, FrameState state) {
        int[] particles = Arrays.stream(setup.scenery.surfaces().get(k).triangles())
                .filter(i -> i < state.particles()).sorted().distinct().toArray();
        int[] corners = surfaces.get(k).in(state);
        String prim = "Mesh \"surface" + k + '"';
        put(prim, "uniform token subdivisionScheme", "", "\"none\"");
        put(prim, "bool doubleSided", "", "true");
        put(prim, "int[] faceVertexCounts", "", corners.length / 3, t -> 3);
        put(prim, "int[] faceVertexIndices", "", corners.length, c -> Arrays.binarySearch(particles, corners[c]));
        put(prim, COLOUR, "", 1, c -> colour(setup.look.colours().front()));
        writePoints(prim, state, particles, n -> 0);
        return Arrays.stream(particles);
    }

    /** Writes curves between pairs of particles. */
    private void writeCurves(String name, FrameState state, double radius, int[] ends) {
        String prim = "BasisCurves \"" + name + '"';
        put(prim, "uniform token type", "", "\"linear\"");
        put(prim, "int[] curveVertexCounts", "", ends.length / 2, k -> 2);
        writePoints(prim, state, ends, k -> radius);
    }

    /** Writes positions and the box around them; where points are thick, also how thick. */
    private void writePoints(String prim, FrameState state, int[] particles, IntToDoubleFunction radius) {
        double[] low = {0, 0, 0};
        double[] high = {0, 0, 0};
        for (int k = 0; k < particles.length; k++) {
            for (int c = 0; c < 3; c++) {
                double x = state.state()[Particles.STRIDE * particles[k] + c];
                low[c] = Math.min(k == 0 ? x : low[c], x - radius.applyAsDouble(k));
                high[c] = Math.max(k == 0 ? x : high[c], x + radius.applyAsDouble(k));
            }
        }
        int n = particles.length;
        put(prim, UsdStage.POINTS, "", n, k -> point(state.place(particles[k])));
        put(prim, "float3[] extent", "", 2, k -> point(Vector3.at(k == 0 ? low : high, 0)));
        put(prim, "string[] primvars:name", OF_EACH, n, k -> '"' + state.structure().ids()[particles[k]]
                .replace("\\", "\\\\") + '"');
        if (n == 0 || radius.applyAsDouble(0) > 0) {
            put(prim, "float[] widths", "", n, k -> number(2 * radius.applyAsDouble(k)));
        }
    }

    private void put(String prim, String declaration, String metadata, int n, IntFunction<Object> value) {
        put(prim, declaration, metadata, IntStream.range(0, n).mapToObj(k -> value.apply(k).toString())
                .collect(Collectors.joining(", ", "[", "]")));
    }

    private void put(String prim, String declaration, String metadata, String value) {
        stage.put(prim, declaration, metadata, now, value);
    }

    private static String number(double value) {
        return Numbers.shortest((float) value);
    }

    private static String point(Vector3 at) {
        return "(" + number(at.x()) + ", " + number(at.y()) + ", " + number(at.z()) + ")";
    }

    /** A colour of the screen as an amount of light. */
    private static String colour(int rgb) {
        double[] light = IntStream.of(16, 8, 0).mapToDouble(shift -> Math.pow((rgb >> shift & 255) / 255.0, 2.2))
                .toArray();
        return point(Vector3.at(light, 0));
    }

    @Override
    public void close() {
        String prim = "Camera \"camera\"";
        Camera camera = setup.camera;
        double distance = camera.position().minus(camera.target()).length();
        // an orthographic camera's aperture is in tenths of a metre
        double film = camera.perspective() ? FILM : 10 * camera.height();
        put(prim, "token projection", "", camera.perspective() ? "\"perspective\"" : "\"orthographic\"");
        put(prim, "float focalLength", "", number(FILM / 2 / Math.tan(Math.toRadians(camera.fieldOfView()) / 2)));
        put(prim, "float verticalAperture", "", number(film));
        put(prim, "float horizontalAperture", "", number(film * setup.width / setup.height));
        put(prim, "float2 clippingRange", "", "(" + number(distance / FAR) + ", " + number(distance * FAR) + ")");
        put(prim, "matrix4d xformOp:transform", "", Stream.of(view.right, view.up, view.back, camera.position())
                .map(row -> point(row).replace(")", row == camera.position() ? ", 1)" : ", 0)"))
                .collect(Collectors.joining(", ", "(", ")")));
        put(prim, "uniform token[] xformOpOrder", "", "[\"xformOp:transform\"]");
        try (stage) {
            stage.finish("""
                    #usda 1.0
                    (
                        defaultPrim = "scene"
                        doc = "%s"
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
                    """.formatted(setup.title.replace("\\", "\\\\").replace("\"", "\\\""), first, now,
                    number(setup.rate)));
        }
    }
}
