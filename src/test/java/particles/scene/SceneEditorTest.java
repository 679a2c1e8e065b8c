package particles.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import particles.scene.format.SceneDescription;
import particles.scene.parts.ParticleDescription;
import particles.spec.ClassNames;
import particles.spec.messages.InvalidInputException;

class SceneEditorTest {
    private static final String HEAD = "title: t\nteaches: t\nsolver: rk4\ndeltaT: 0.01\nduration: 1\n";
    private static final String MASS = "{id: m1, position: [0, 0, 0]}";

    static Stream<Path> scenes() throws IOException {
        return SceneFiles.list(Path.of("scenes")).stream();
    }

    private static SceneDescription read(String text) {
        return SceneReader.read("scene", text.getBytes(StandardCharsets.UTF_8));
    }

    private static void build(String text) {
        SceneBuilder.build(read(text));
    }

    private static SceneEditor edit(String text) {
        return new SceneEditor(text);
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void everySceneTakesMassesSpringsAndMusclesAndLosesThemAgain(Path file) {
        String text = SceneReader.withFiles(file, ClassNames.none(), List.of());
        String masses = edit(edit(text).place(0.1, 1.2, 0.1)).place(0.1, 1.3, 0.1);
        String fixed = edit(masses).toggleFixed("m2");
        assertEquals(masses.replace("[0.1, 1.3, 0.1]}", "[0.1, 1.3, 0.1], fixed: true}"), fixed);
        String spring = edit(fixed).join("m1", "m2", false);
        String muscle = edit(spring).join("m2", "m1", true);
        String one = edit(muscle).remove("m2");
        Stream.of(masses, fixed, edit(fixed).toggleFixed("m2"), spring, muscle, edit(fixed).join("m1", "m2", true), one)
                .forEach(SceneEditorTest::build);
        assertEquals(words(masses.replace("  - {id: m2, position: [0.1, 1.3, 0.1]}\n", "")), words(one));
        assertEquals(words(text), words(edit(one).remove("m1")));
    }

    private static String words(String text) {
        return text.replaceAll("\\s+", " ").strip();
    }

    private static List<String> ids(String text) {
        return read(text).particles().getParticles().stream().map(ParticleDescription::id).toList();
    }

    /** Of five scenes it is the last one, and a scene has one. */
    @Test
    void withoutAnyOfItsOtherParticlesEachSceneIsAScene() throws IOException {
        int last = 0;
        for (Path file : scenes().toList()) {
            String text = SceneReader.withFiles(file, ClassNames.none(), List.of());
            for (String id : ids(text)) {
                if (read(text).particles().count() > 1) {
                    build(edit(text).remove(id));
                } else {
                    last++;
                    List<String> lines = assertThrows(InvalidInputException.class, () -> build(edit(text).remove(id)))
                            .getLines();
                    assertTrue(lines.get(0).contains("the scene has no particle"), lines::toString);
                }
            }
        }
        assertEquals(5, last);
    }

    @Test
    void commentsAndLayoutStay() {
        String text = HEAD + """
                particles:
                  - id: a           # the first
                    position: [0, 0, 0]
                    # heavy
                    mass: 3         # kg

                # between two lists
                springs: []
                effects:
                - gravity           # not indented
                """;
        assertEquals(text.replace("# kg\n", "# kg\n    fixed: true\n"), edit(text).toggleFixed("a"));
        String placed = edit(text).place(1, 0, 0.5);
        assertEquals(text.replace("# kg\n", "# kg\n  - {id: m1, position: [1, 0, 0.5]}\n"), placed);
        assertEquals(text, edit(placed).remove("m1"));
        assertEquals(placed.replace("springs: []", "springs: [{from: a, to: m1, stiffness: 100, damping: 1}]")
                + "- muscles: {amplitude: 0.2, period: 1, springs: [{from: a, to: m1}]}\n",
                edit(placed).join("a", "m1", true));
    }

    @Test
    void windowsLineEndsStayAndAByteOrderMarkGoes() {
        String text = HEAD + """
                particles:
                  - {id: a, position: [0, 0, 0]}
                  - {id: b, position: [0, 1, 0]}    # the second

                effects:
                  - gravity
                """;
        SceneEditor windows = edit("\ufeff" + text.replace("\n", "\r\n"));
        for (List<String> both : List.of(List.of(edit(text).place(1, 0, 0), windows.place(1, 0, 0)),
                List.of(edit(text).toggleFixed("b"), windows.toggleFixed("b")),
                List.of(edit(text).join("a", "b", true), windows.join("a", "b", true)),
                List.of(edit(text).remove("b"), windows.remove("b")))) {
            build(both.get(0));
            assertEquals(both.get(0).replace("\n", "\r\n"), both.get(1));
        }
    }

    @Test
    void aDashMayStandLinesBeforeItsEntryAndTheWholeSceneFurtherRight() {
        String text = (HEAD + """
                particles:
                  - # left - first
                    id: a
                    position: [0, 0, 0]
                  -
                    # right - second
                    id: b
                    position: [0, 1, 0]
                """).replaceAll("(?m)^(?=.)", "  ");
        assertEquals(text.substring(0, text.indexOf("    -\n")), edit(text).remove("b"));
        assertEquals(text.substring(0, text.indexOf("    - #")) + text.substring(text.indexOf("    -\n")),
                edit(text).remove("a"));
        String joined = edit(text).join("a", "b", false);
        assertEquals(text + "\n  springs:\n    - {from: a, to: b, stiffness: 100, damping: 1}\n", joined);
        build(joined);
    }

    @Test
    void aSceneInFlowStyleStaysInFlowStyle() {
        String text = "{title: t, teaches: t, solver: rk4, deltaT: 0.01, duration: 1, particles: [" + MASS + ",\n ]}";
        String joined = edit(edit(text).place(0, 1, 0)).join("m1", "m2", true);
        assertEquals(text.replace(MASS, MASS + ", {id: m2, position: [0, 1, 0]}").replace(" ]}", " ], springs:"
                + " [{from: m1, to: m2, stiffness: 100, damping: 1}], effects: [muscles: {amplitude: 0.2, period: 1,"
                + " springs: [{from: m1, to: m2}]}]}"), joined);
        build(joined);
        assertEquals(text, edit(joined).remove("m2"));
    }

    @Test
    void onlyWhatNamesAParticleGoesWithIt() {
        String text = HEAD + """
                particles: [{id: top, position: [0, 0, 0]}, {id: gravity, position: [1, 1, 0]},
                            {id: 😀, position: [9, 9, 9]}]
                shapes:
                  - cloth: {corner: [0, 2, 0], across: [1, 0, 0], down: [0, -1, 0], columns: 2, rows: 2, mass: 1,
                            fixed: top, structural: {stiffness: 1}}
                springs:
                  - {from: gravity, to: 😀, stiffness: 1}
                  - {from: top, to: "cloth[0,1]", stiffness: 1}
                effects:
                  - gravity
                look:
                  marks: [{particle: top, label: gravity}]
                  trail: 2
                output: {phase: {particle: gravity, axis: y}}
                """;
        assertEquals(text.replace(" {id: gravity, position: [1, 1, 0]},", "")
                .replace("  - {from: gravity, to: 😀, stiffness: 1}\n", "")
                .replace("output: {phase: {particle: gravity, axis: y}}\n", ""), edit(text).remove("gravity"));
        assertEquals(text.replace("{id: top, position: [0, 0, 0]}, ", "")
                .replace("  - {from: top, to: \"cloth[0,1]\", stiffness: 1}\n", "")
                .replace("  marks: [{particle: top, label: gravity}]\n", ""), edit(text).remove("top"));
        assertTrue(edit(text).join("top", "cloth[1,1]", false).contains("{from: top, to: \"cloth[1,1]\", stiffness"));
    }

    @Test
    void aTextThatIsNoYamlIsRefused() {
        List<String> lines = assertThrows(InvalidInputException.class, () -> edit("a: [1]\n b: 2")).getLines();
        assertEquals(List.of("scene:2:2: not valid YAML: this line is not indented like the lines that it follows"),
                lines);
    }
}
