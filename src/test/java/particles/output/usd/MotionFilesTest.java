package particles.output.usd;

import static deSolvers.problems.Bounds.assertBelow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Texts.assertHas;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.NavigableMap;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import particles.law.Particles;
import particles.law.Vector3;
import particles.output.files.OutputFolder;
import particles.output.frames.FrameObserver;
import particles.output.frames.FrameRenderer.FrameSetup;
import particles.output.painters.FrameState;
import particles.scene.Scene;
import particles.scene.SceneBuilder;
import particles.scene.TestScenes;
import particles.view.Camera;
import particles.view.ParticleStyle;

/** The motion of a run as a USD stage and as OBJ files, read back and compared with the states of the run. */
class MotionFilesTest {
    /** A cloth that tears off a spring's ball, and balls that are born and die. */
    private static final String SCENE = """
            title: "A \\"cloth\\" and balls"
            teaches: what a stage holds
            solver: rk4
            deltaT: 0.01
            duration: 1.2
            particles:
              - {id: hook, position: [-1, 1, 0], fixed: true}
              - {id: ball, position: [0, 2, 0], velocity: [0.5, 0, 0.25]}
            shapes:
              - cloth: {corner: [0, 0, 0], across: [1, 0, 0], down: [0, -1, 0], columns: 3, rows: 2, mass: 1,
                  fixed: top-left, structural: {stiffness: 50}, shear: {stiffness: 50}}
            springs:
              - {from: ball, to: "cloth[1,0]", stiffness: 20}
            lines:
              - {from: hook, to: ball}
            effects: [gravity]
            rules:
              - emitter: {id: jet, position: [2, 0, 0], speed: 1, rate: 9.7, lifetime: 0.31}
            """;
    private static final Camera CAMERA = new Camera(new Vector3(1, 2, 9), new Vector3(1, 2, 0), new Vector3(0, 1, 0),
            true, 40, 0);
    private static final int RATE = 20;
    private static final Pattern PRIM = Pattern.compile("(?ms)^    def (\\w+) \"(\\w+)\"\n    \\{\n(.*?)^    }\n");
    private static final Pattern ATTRIBUTE = Pattern.compile(
            "(?ms)^        (?:uniform )?(\\S+ [\\w:]+)(?: = ([^\n]*?)(?: \\(\n[^)]*\\))?$"
            + "|\\.timeSamples = \\{\n(.*?)^        })");
    private static final Pattern SAMPLE = Pattern.compile("(?m)^            (\\d+): (.*),$");

    @TempDir
    Path top;
    private final List<FrameState> states = new ArrayList<>();
    /** The samples of each attribute by its prim and name. */
    private final Map<String, NavigableMap<Integer, String>> stage = new HashMap<>();
    private String text;

    @BeforeEach
    void run() throws IOException {
        Scene scene = TestScenes.build(SCENE);
        try (OutputFolder folder = OutputFolder.open(top)) {
            FrameSetup setup = new FrameSetup(CAMERA, scene.description().drawing().look(), scene.scenery(),
                    scene.description().title(), "rk4");
            try (FrameObserver frames = new FrameObserver(setup.look().style(), RATE, List.of(
                    new UsdFile(folder, setup, 640, 360, RATE), new ObjFrames(folder, scene.scenery().surfaces()),
                    (frame, state) -> states.add(state)))) {
                scene.simulation().addObserver(frames);
                scene.simulation().run();
            }
        }
        text = Files.readString(top.resolve(UsdFile.FILE));
        Matcher prim = PRIM.matcher(text);
        while (prim.find()) {
            Matcher attribute = ATTRIBUTE.matcher(prim.group(3));
            while (attribute.find()) {
                NavigableMap<Integer, String> samples = stage.computeIfAbsent(prim.group(1) + " " + prim.group(2) + " "
                        + attribute.group(1), key -> new TreeMap<>());
                if (attribute.group(2) != null) {
                    samples.put(Integer.MIN_VALUE, attribute.group(2));
                } else {
                    SAMPLE.matcher(attribute.group(3)).results()
                            .forEach(sample -> samples.put(Integer.parseInt(sample.group(1)), sample.group(2)));
                }
            }
        }
    }

    /** The value that a reader holds at a frame. */
    private String at(String attribute, int frame) {
        return stage.get(attribute).floorEntry(frame).getValue();
    }

    private List<String> list(String attribute, int frame) {
        String inside = at(attribute, frame).replaceAll("^\\[|]$", "");
        return inside.isEmpty() ? List.of() : List.of(inside.split(inside.contains("(") ? ", (?=\\()" : ", "));
    }

    private static Vector3 point(String tuple) {
        return Vector3.at(Stream.of(tuple.replaceAll("[()]", "").split(", ")).mapToDouble(Double::parseDouble)
                .toArray(), 0);
    }

    /** In single precision, a coordinate below 8 m is off by at most 2.4e-7 m. */
    @Test
    void everyParticleIsWhereItWasInTheRun() {
        assertEquals(25, states.size());                // from 0 to 1.2 s
        double worst = 0;
        for (int frame = 0; frame < states.size(); frame++) {
            FrameState state = states.get(frame);
            Map<String, Vector3> read = new HashMap<>();
            for (String prim : List.of("Mesh surface0 ", "Points particles ")) {
                List<String> names = list(prim + "string[] primvars:name", frame);
                List<String> points = list(prim + "point3f[] points", frame);
                assertEquals(names.size(), points.size());
                IntStream.range(0, names.size()).forEach(k -> read.put(names.get(k).replace("\"", ""),
                        point(points.get(k))));
            }
            assertEquals(state.particles(), read.size());
            for (int i = 0; i < state.particles(); i++) {
                worst = Math.max(worst, state.place(i).minus(read.get(state.structure().ids()[i])).length());
            }
        }
        assertBelow(1e-6, worst);                       // measured 3.2e-7
        assertTrue(worst > 0, "they are in single precision");
    }

    /** Balls of the jet come and go; a ball keeps its number, and has a thickness and a colour in every frame. */
    @Test
    void bornAndDeadBallsChangeTheCounts() {
        Map<String, String> numbers = new HashMap<>();
        List<Integer> counts = new ArrayList<>();
        for (int frame = 0; frame < states.size(); frame++) {
            List<String> ids = list("Points particles int64[] ids", frame);
            List<String> names = list("Points particles string[] primvars:name", frame);
            counts.add(ids.size());
            assertEquals(ids.size(), list("Points particles float[] widths", frame).size());
            assertEquals(ids.size(), list("Points particles color3f[] primvars:displayColor", frame).size());
            for (int k = 0; k < ids.size(); k++) {
                numbers.putIfAbsent(names.get(k), ids.get(k));
                assertEquals(ids.get(k), numbers.get(names.get(k)));
            }
        }
        assertEquals(numbers.size(), numbers.values().stream().distinct().count(), "no number is used twice");
        assertEquals(2, counts.get(0));
        assertEquals(5, counts.stream().mapToInt(Integer::intValue).max().orElseThrow());
        assertEquals(13, numbers.size());
    }

    @Test
    void surfacesAreMeshesAndSpringsAndLinesAreCurves() {
        assertEquals("[3, 3, 3, 3]", at("Mesh surface0 int[] faceVertexCounts", 0));
        assertEquals("[0, 1, 3, 0, 3, 2, 2, 3, 5, 2, 5, 4]", at("Mesh surface0 int[] faceVertexIndices", 9));
        assertEquals("[2, 2]", at("BasisCurves springs int[] curveVertexCounts", 3));
        List<String> ends = list("BasisCurves springs string[] primvars:name", 3);
        List<String> points = list("BasisCurves springs point3f[] points", 3);
        List<Double> widths = list("BasisCurves springs float[] widths", 3).stream().map(Double::valueOf).toList();
        assertEquals(2, Collections.frequency(ends, "\"ball\""), "the ball is at the end of the spring and the line");
        for (int k = 0; k < 4; k++) {
            if (ends.get(k).equals("\"ball\"")) {
                assertEquals(0, point(points.get(k)).minus(states.get(3).place(1)).length(), 1e-6);
            }
        }
        int line = ends.indexOf("\"hook\"") / 2;
        assertEquals(2.0 / 3, widths.get(2 * line) / widths.get(2 * (1 - line)), 1e-6,
                "lines are thinner than springs");
    }

    /** 2 atan(20.25 / (2 f)) is the angle of 40 degrees, and the aspect of the picture that of the film. */
    @Test
    void theStageHasUnitsTimesAndTheCamera() {
        for (String line : List.of("#usda 1.0", "metersPerUnit = 1", "upAxis = \"Y\"", "startTimeCode = 0",
                "endTimeCode = 24", "timeCodesPerSecond = 20.0", "doc = \"A \\\"cloth\\\" and balls: rk4\"")) {
            assertHas(text, line);
        }
        double focal = Double.parseDouble(at("Camera camera float focalLength", 0));
        assertEquals(40, Math.toDegrees(2 * Math.atan(20.25 / 2 / focal)), 1e-5);
        assertEquals(36, Double.parseDouble(at("Camera camera float horizontalAperture", 0)), 1e-5);
        assertEquals("((1.0, 0.0, 0.0, 0), (0.0, 1.0, 0.0, 0), (0.0, 0.0, 1.0, 0), (1.0, 2.0, 9.0, 1))",
                at("Camera camera matrix4d xformOp:transform", 0));
    }

    /** A value that stays is not repeated; between its two ends a reader interpolates two equal values. */
    @Test
    void whatStaysIsWrittenOnce() {
        assertEquals(1, stage.get("Mesh surface0 int[] faceVertexIndices").size());
        assertEquals(25, stage.get("Points particles point3f[] points").size());
        assertEquals(text.chars().filter(c -> c == '[').count(), text.chars().filter(c -> c == ']').count());
        assertEquals(text.chars().filter(c -> c == '{').count(), text.chars().filter(c -> c == '}').count());
    }

    /** The shape 'mesh' reads the frames back: the same positions to the last bit, faces, and springs as lines. */
    @Test
    void anObjFrameIsAMesh() throws IOException {
        for (int frame : new int[] {0, 7, 24}) {
            String obj = Files.readString(top.resolve("frames/frame-%05d.obj".formatted(frame)));
            Scene read = SceneBuilder.build(TestScenes.read("""
                    title: Back
                    teaches: reading
                    solver: rk4
                    deltaT: 1
                    duration: 1
                    shapes:
                      - mesh: {file: f, mass: 1, structural: {stiffness: 1}}
                    files:
                      f: |2
                    """ + obj.indent(4)));
            FrameState state = states.get(frame);
            assertEquals(state.particles(), read.system().getParticles().count());
            for (int i = 0; i < state.particles(); i++) {
                assertEquals(state.place(i), Vector3.at(read.system().getOwnState(), Particles.STRIDE * i));
            }
            assertEquals(12, read.scenery().surfaces().get(0).triangles().length);
            assertEquals(2 + 7 + 4, read.springs().springCount(), "springs and lines, and edges of faces");
        }
        assertEquals(25, states.size());
        try (Stream<Path> files = Files.list(top.resolve("frames"))) {
            assertEquals(25, files.count());
        }
    }

    /** A frame at every step: after the rule that puts the ball on the ground, as in the trajectory, never below it. */
    @Test
    void aFrameAtTheEndOfAStepIsTheStateAfterRules() {
        Scene scene = TestScenes.build("""
                {title: Drop, teaches: rules, solver: rk4, deltaT: 0.01, duration: 0.6, effects: [gravity],
                particles: [{id: ball, position: [0, 0.1, 0]}], rules: [ground: {restitution: 0.7}]}""");
        List<Double> heights = new ArrayList<>();
        try (FrameObserver frames = new FrameObserver(ParticleStyle.STANDARD, 100,
                List.of((frame, state) -> heights.add(state.place(0).y())))) {
            scene.simulation().addObserver(frames);
            scene.simulation().run();
        }
        assertEquals(61, heights.size());
        assertTrue(heights.stream().allMatch(y -> y >= 0), heights.toString());     // before the rule -0.04 m
        assertTrue(heights.contains(0.0), "it bounces");
    }

    @Test
    void nothingIsLeftBesideTheFiles() throws IOException {
        try (Stream<Path> files = Files.list(top)) {
            assertEquals(List.of(".desolver-made", "frames", "motion.usda"),
                    files.map(file -> file.getFileName().toString()).sorted().toList());
        }
        OutputFolder.open(top).close();                 // the next run
        assertFalse(Files.exists(top.resolve("frames")));
        assertFalse(Files.exists(top.resolve(UsdFile.FILE)));
    }
}
