package particles.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assumptions.assumeTrue;
import static particles.Texts.assertStarts;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import particles.spec.messages.InvalidInputException;

class SceneFilesTest {
    @TempDir
    private Path folder;

    @BeforeEach
    void makeScenes() throws IOException {
        for (String name : List.of("01-one.yaml", "03-one-spring.yaml", "12-cloth.yaml", "free.yaml", "notes.txt",
                ".hidden.yaml")) {
            Files.writeString(folder.resolve(name), "");
        }
    }

    private String refusal(String wanted) {
        List<String> lines = assertThrows(InvalidInputException.class,
                () -> SceneFiles.find(folder, wanted)).getLines();
        assertEquals(1, lines.size());
        return lines.get(0);
    }

    @Test
    void aSceneIsFoundByNumberNameAndPath() throws IOException {
        for (String name : List.of("12", "12-cloth", "cloth.yaml")) {
            assertEquals(folder.resolve("12-cloth.yaml"), SceneFiles.find(folder, name), name);
        }
        Path mine = Files.writeString(folder.resolve("a scene of mine.yaml"), "");
        assertEquals(mine, SceneFiles.find(Path.of("scenes"), mine.toString()));
    }

    @Test
    void anUnknownSceneIsOneLineWithTheNearest() {
        String known = " scenes: 01-one, 03-one-spring, 12-cloth, free";
        assertEquals("there is no scene 'one-sprong'; did you mean 'one-spring'?" + known, refusal("one-sprong"));
        assertEquals("there is no scene '99';" + known, refusal("99"));
        assertEquals("there is no scene '';" + known, refusal(""));
    }

    @Test
    void theErrorForAnInvalidPathNamesTheReason() throws IOException {
        Path misspelt = folder.resolve("12-clth.yaml");
        assertEquals("there is no file '" + misspelt + "'; did you mean '12-cloth.yaml'?",
                refusal(misspelt.toString()));
        Path nowhere = folder.resolve("no/a.yaml");
        assertEquals("there is no file '" + nowhere + "'", refusal(nowhere.toString()));
        assertEquals("'" + folder + "' is a folder; a scene is an ordinary file", refusal(folder.toString()));
        assumeTrue(Files.exists(Path.of("/dev/null")));
        assertEquals("'/dev/null' is a device, a pipe or a socket; a scene is an ordinary file",
                refusal("/dev/null"));
    }

    @Test
    void twoScenesOfOneNumberHaveToBeNamed() throws IOException {
        Files.writeString(folder.resolve("3-other.yaml"), "");
        assertEquals("'3' matches more than one"
                + " scene: " + folder.resolve("03-one-spring.yaml") + ", " + folder.resolve("3-other.yaml")
                + "; give the whole name", refusal("3"));
        assertEquals(folder.resolve("3-other.yaml"), SceneFiles.find(folder, "other"));
    }

    @Test
    void aMissingFolderIsOneLine() {
        Path missing = folder.resolve("none");
        assertStarts(assertThrows(InvalidInputException.class, () -> SceneFiles.list(missing)).getLines().get(0),
                "the folder of scenes, " + missing + ", cannot be read");
    }

    @Test
    void theDefaultSceneIsThere() {
        assertEquals(Path.of("scenes", "09-cloth-in-wind.yaml"),
                SceneFiles.find(Path.of("scenes"), SceneFiles.DEFAULT));
    }
}
