package hunts;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.snakeyaml.engine.v2.api.Load;
import org.snakeyaml.engine.v2.api.LoadSettings;
import org.snakeyaml.engine.v2.schema.CoreSchema;
import particles.scene.SceneFiles;

/** Written YAML reads back as the same tree. */
class FlowTextTest {
    private static Object read(String yaml) {
        return new Load(LoadSettings.builder().setSchema(new CoreSchema()).build()).loadFromString(yaml);
    }

    private static void assertComesBack(Object tree) {
        StringBuilder text = new StringBuilder();
        FlowText.append(tree, text);
        assertEquals(tree, read(text.toString()), text.toString());
    }

    @Test
    void allKindsOfValuesComeBack() {
        assertComesBack(Arrays.asList(1, -1L << 40, 0.5, 1e-30, -1e308, 5e-324, Double.NaN, Double.NEGATIVE_INFINITY,
                true, null));
        assertComesBack(List.of("", " ", "~", "a\nb", "true", "null", "12", "1e3", ".inf", "rk4", "cloth[1,2]",
                "#00ff00",
                "a: b", "it's", "\"", "\\", "\u00e4\u2028\ud83d\ude00", "- x", "x,y", "y", "a b", "a."));
        assertComesBack(Map.of("a", Map.of(), "b", List.of(), "two words", List.of(List.of(0, 1), Map.of("3", 4))));
    }

    @Test
    void everySceneComesBack() throws IOException {
        for (Path file : SceneFiles.list(Path.of("scenes"))) {
            assertComesBack(read(Files.readString(file)));
        }
    }
}
