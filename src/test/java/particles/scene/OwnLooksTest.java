package particles.scene;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import particles.law.Vector3;
import particles.output.frames.FrameObserver;
import particles.output.frames.FrameRenderer;
import particles.output.frames.FrameRenderer.FrameSetup;
import particles.output.frames.FrameSink;
import particles.spec.messages.InvalidInputException;
import particles.view.Camera;
import particles.view.RenderOptions;

/** Lines, listed faces, and colours and trails of one's own: as they are read, and as they are drawn. */
class OwnLooksTest {
    private static final int SIDE = 120;
    private static final String HEAD = """
            title: Looks
            teaches: drawing
            solver: rk4
            deltaT: 0.01
            duration: 0.5
            particles:
              - {id: a, position: [-1, -1, 0], fixed: true}
              - {id: b, position: [1, -1, 0], fixed: true}
              - {id: c, position: [1, 1, 0], fixed: true}
              - {id: d, position: [-1, 1, 0], velocity: [2, 0, 0]}
            """;
    private static final String PLAIN = "look: {particles: never, background: '#000000'%s}\n";
    private static final Camera FRONT = new Camera(new Vector3(0, 0, 9), Vector3.ZERO, new Vector3(0, 1, 0), false, 0,
            3);

    /** The last frame of a scene, without its words. */
    private static int[] picture(String more) {
        Scene scene = TestScenes.build(HEAD + more);
        FrameRenderer renderer = new FrameRenderer(new FrameSetup(FRONT, scene.description().drawing().look(),
                scene.scenery(), "", ""), SIDE, SIDE, Optional.empty());
        List<int[]> frames = new ArrayList<>();
        FrameSink sink = (index, rgb) -> () -> frames.add(rgb.clone());
        try (FrameObserver observer = new FrameObserver(renderer, 20, List.of(sink))) {
            scene.simulation().addObserver(observer);
            scene.simulation().run();
        }
        return frames.get(frames.size() - 1);
    }

    private static long count(int[] picture, int hidden) {
        return Arrays.stream(picture).filter(rgb -> (rgb & hidden) != 0).count();
    }

    @Test
    void theBackgroundIsOneColourAndChoosesTheTextsColour() {
        assertTrue(Arrays.stream(picture("look: {particles: never, background: '#123456'}\n"))
                .allMatch(rgb -> (rgb & 0xffffff) == 0x123456));
        assertTrue(look("look: {background: '#123456'}\n").style().night(), "light text");
        assertTrue(!look("look: {background: '#fedcba'}\n").style().night(), "dark text");
        assertTrue(!look("look: {background: '#123456', sky: day}\n").style().night(), "as it says");
    }

    private static RenderOptions look(String more) {
        return TestScenes.read(HEAD + more).drawing().look();
    }

    /** A red line from a to b, 2 of 3 m wide: about 80 of 120 columns, and nothing that is green or blue. */
    @Test
    void aLineIsDrawnInTheColourOfSpringsAndExertsNoForce() {
        String line = "lines:\n  - {from: a, to: b}\n";
        Scene scene = TestScenes.build(HEAD + line + "  - {from: a, to: d}\n");
        double[] forces = new double[scene.system().getStateSize()];
        scene.system().getEffects().forEach(effect -> effect.addForces(scene.system().getOwnState(), 0, forces));
        assertEquals(1, scene.system().getEffects().size(), "they are springs");
        assertTrue(Arrays.stream(forces).allMatch(force -> force == 0));
        int[] picture = picture(line + PLAIN.formatted(", springColour: '#ff0000'"));
        long columns = IntStream.range(0, SIDE).filter(x -> IntStream.range(0, SIDE)
                .anyMatch(y -> (picture[y * SIDE + x] & 0xff0000) != 0)).count();
        assertTrue(columns >= 80 && columns <= 86, "columns: " + columns);         // measured 82
        assertEquals(0, count(picture(PLAIN.formatted("")), 0xffffff), "nothing else is drawn");
        assertEquals("x.yaml:12:19: unknown particle 'z'; known: a, b, c, d", message(
                "lines:\n  - {from: a, to: z}\n"));
    }

    /** Springs in one colour show no strain: no red of a stretched one. */
    @Test
    void springsMayHaveOneColour() {
        String springs = "springs:\n  - {from: c, to: d, stiffness: 1, restLength: 1}\n";
        assertTrue(count(picture(springs + PLAIN.formatted("")), 0xff0000) > 0);
        int[] blue = picture(springs + PLAIN.formatted(", springColour: '#0000ff'"));
        assertTrue(count(blue, 0x0000ff) > 0);
        assertTrue(Arrays.stream(blue).allMatch(rgb -> (rgb >> 16 & 255) <= (rgb & 255)));
    }

    /** Half a square of 80 x 80 pixels; counter-clockwise corners show the front. */
    @Test
    void listedFacesAreASurfaceWithTwoSides() {
        String still = PLAIN.formatted(", frontColour: '#ff0000', backColour: '#0000ff'");
        for (String corners : List.of("[a, b, c]", "[c, b, a]")) {
            int[] picture = picture("faces:\n  - " + corners + "\n" + still);
            long drawn = count(picture, 0xffffff);
            assertTrue(drawn > 3000 && drawn < 3400, "half of 80 x 80: " + drawn);          // measured 3240
            assertEquals(corners.startsWith("[a"), count(picture, 0xff0000) > 3000);
            assertEquals(corners.startsWith("[c"), count(picture, 0x0000ff) > 3000);
        }
        assertArrayEquals(new int[] {0, 1, 2, 0, 2, 3}, TestScenes.build(HEAD + "faces:\n  - [a, b, c, d]\n").scenery()
                .surfaces().get(0).triangles());
        assertEquals("x.yaml:12:5: a face needs at least three corners, all different",
                message("faces:\n  - [a, b, a]\n"));
        assertTrue(message("faces:\n  - [a, b, z]\n").contains("unknown particle 'z'"));
    }

    /** d moves 1 m in 0.5 s: a trail of its own is seen where the others have none, and a shorter one is shorter. */
    @Test
    void aParticleMayHaveATrailOfItsOwn() {
        String mark = ", marks: [{particle: d, trail: %s, colour: '#00ff00'}]";
        long none = count(picture(PLAIN.formatted("").replace("never", "always")), 0x00ff00);
        long brief = count(picture(PLAIN.formatted(mark.formatted(0.1)).replace("never", "always")), 0x00ff00);
        long whole = count(picture(PLAIN.formatted(mark.formatted(0.5)).replace("never", "always")), 0x00ff00);
        assertTrue(none < brief && brief < whole, none + " < " + brief + " < " + whole);
        assertEquals(0.5, look(PLAIN.formatted(mark.formatted(0.5))).style().longestTrail());
    }

    private static String message(String more) {
        return assertThrows(InvalidInputException.class, () -> TestScenes.build(HEAD + more)).getMessage();
    }
}
