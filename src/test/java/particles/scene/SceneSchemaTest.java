package particles.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import particles.scene.format.SceneFormat;
import particles.spec.JsonSchema;
import particles.spec.Reference;

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

    /** GalleryTest compares the reference with the page; its links lead to its sections. */
    @Test
    void everyLinkOfTheReferenceLeadsToASection() {
        String reference = Reference.of(SceneFormat.SCENE, "###");
        List<String> links = Pattern.compile("\\(#([^)]*)\\)").matcher(reference).results()
                .map(link -> link.group(1)).distinct().toList();
        assertTrue(links.containsAll(List.of("a-particle", "friction", "the-camera")), links.toString());
        List<String> sections = reference.lines().filter(line -> line.startsWith("### "))
                .map(line -> line.substring(4).toLowerCase(Locale.ROOT).replace("`", "").replace(' ', '-')).toList();
        links.forEach(link -> assertEquals(1, Collections.frequency(sections, link), link));
    }
}
