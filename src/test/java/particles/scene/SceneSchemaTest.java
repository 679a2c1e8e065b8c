package particles.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

class SceneSchemaTest {

    /** The file is for editors and belongs into the repository; it is made from what the reader reads by. */
    @Test
    void theSchemaBesideTheScenesIsTheOneThatTheReaderReadsBy() throws IOException {
        String generated = SceneFormat.jsonSchema();
        Path made = Files.createDirectories(Path.of("build")).resolve("scene.schema.json");
        Files.writeString(made, generated);
        assertEquals(Files.readString(Path.of("scenes", "scene.schema.json")), generated,
                "scenes/scene.schema.json is out of date; if the change is meant, copy " + made + " over it");
    }
}
