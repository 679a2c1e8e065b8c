package particles.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import particles.scene.format.SceneFormat;
import particles.spec.JsonSchema;

class SceneSchemaTest {

    /** The schema file is for editors; it must equal the one generated from the scene format. */
    @Test
    void theSchemaFileIsUpToDate() throws IOException {
        String generated = JsonSchema.ofScenes(SceneFormat.SCENE);
        Path made = Files.createDirectories(Path.of("build")).resolve("scene.schema.json");
        Files.writeString(made, generated);
        assertEquals(Files.readString(Path.of("scenes", "scene.schema.json")), generated,
                "scenes/scene.schema.json is out of date; if the change is meant, copy " + made + " over it");
    }

    /** One row for each key, and one section for each mapping, even if several keys refer to it. */
    @Test
    void theReferenceHasARowForEachKey() {
        List<String> lines = SceneFormat.reference("###").lines().toList();
        assertTrue(lines.contains("| `deltaT` | a number over 0 (s) | *required* | The time step (s). |"));
        assertTrue(lines.contains("| `acceleration` | three numbers [x, y, z] (m/s^2) | [0, -9.81, 0] | g, the"
                + " acceleration of free fall (m/s^2). |"));
        for (String heading : List.of("The scene", "A particle", "`rope`", "`cloth`", "`jelly`", "A spring",
                "`gravity`",
                "`wind`", "`drag`", "`ground`", "`plane`", "`friction`", "The camera", "The look", "The output")) {
            assertEquals(1, lines.stream().filter(("### " + heading)::equals).count(), heading);
        }
        long rows = lines.stream().filter(line -> line.startsWith("| `")).count();
        long described = JsonSchema.ofScenes(SceneFormat.SCENE).lines()
                .filter(line -> line.contains("\"description\"")).count();
        assertTrue(rows > 80 && rows < described, rows + " rows, " + described + " descriptions in the schema");
    }
}
