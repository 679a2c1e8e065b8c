package particles.teaching.exercises;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Texts.assertHas;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import particles.teaching.exercises.Exercise.Mark;

/** A scene of the student's own is run, and each requirement holds or does not. */
class SceneDesignTest {
    /** A net of twelve with more springs than anyone is asked for, which falls on the ground and loses its motion. */
    private static final String GOOD = """
            title: A lattice falls
            teaches: Bounces and damping take energy, and the books know how much.
            solver: rk4
            deltaT: 0.002
            duration: 6
            impact: exact
            shapes:
              - cloth: {id: net, corner: [0, 1, 0], across: [1, 0, 0], down: [0, 1, 0], columns: 4, rows: 3, mass: 0.1,
                      structural: {stiffness: 40, damping: 0.1}}
            effects: [gravity, drag: {coefficient: 0.02}]
            rules: [ground: {restitution: 0.6}]
            """;

    @TempDir
    private Path folder;

    private Mark mark(String student, String scene) throws IOException {
        Path file = folder.resolve("scene.yaml");
        Files.writeString(file, scene);
        return new SceneDesign().mark(new Draw(student, 12), file.toString());
    }

    @Test
    void aSceneThatDoesAllIsRight() throws IOException {
        for (String student : List.of("ann", "bob", "cy")) {
            Mark mark = mark(student, GOOD);
            assertTrue(mark.right(), new SceneDesign().text(new Draw(student, 12)) + mark.lines());
            assertEquals(8, mark.lines().size());
        }
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            solver: rk4 => solver: euler | does not hold: solver: one of the catalogue, and not euler (here: euler)
            solver: rk4 => solver: exercises.Mine | does not hold: solver: one of the catalogue, and not euler (here: \
            exercises.Mine)
            columns: 4, rows: 3 => columns: 2, rows: 2 | does not hold: at least
            duration: 6 => duration: 0.5 | does not hold: duration: at least
            deltaT: 0.002 => deltaT: 0.00002 | does not hold: it runs to its end
            deltaT: 0.002 => deltaT: 0.00002 | not looked at: the numerical error
            rules: [ground: {restitution: 0.6}] => | does not hold: at least
            restitution: 0.6 => restitution: 1; , drag: {coefficient: 0.02} =>; , damping: 0.1 => \
            | does not hold: damping, drag and bounces take
            solver: rk4 => solver: backward-euler; deltaT: 0.002 => deltaT: 0.1; impact: exact => impact: clamp \
            | does not hold: the numerical error
            """)
    void whatIsMissingIsSaid(String changes, String line) throws IOException {
        String scene = GOOD;
        for (String change : changes.split("; ")) {
            String[] words = change.split(" => ?", 2);
            scene = scene.replace(words[0], words[1]);
        }
        Mark mark = mark("ann", scene);
        assertFalse(mark.right());
        assertTrue(mark.lines().stream().anyMatch(l -> l.startsWith(line)), line + " among " + mark.lines());
    }

    @Test
    void whatIsNoSceneIsSaid() throws IOException {
        Draw draw = new Draw("ann", 12);
        assertEquals(List.of("The answer is empty; the path of a scene file is wanted, such as my-scene.yaml."),
                new SceneDesign().mark(draw, " ").lines());
        assertEquals(List.of(folder + "/none.yaml: there is no such file"), new SceneDesign().mark(draw,
                folder.resolve("none.yaml").toString()).lines());
        assertHas(new SceneDesign().mark(draw, "a\0b").lines().get(0), "is no path of a file");
        assertHas(mark("ann", GOOD.replace("gravity", "gravty")).lines().get(0), "did you mean 'gravity'?");
    }
}
