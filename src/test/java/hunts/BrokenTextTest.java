package hunts;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.snakeyaml.engine.v2.api.Load;
import org.snakeyaml.engine.v2.api.LoadSettings;
import org.snakeyaml.engine.v2.schema.CoreSchema;

/** Written YAML is one line that reads back as the same tree. */
class BrokenTextTest {
    @Test
    void allKindsOfValuesComeBack() {
        List<Object> shared = List.of(List.of(0, 1), Map.of("3", 4));
        Object tree = Arrays.asList(1, -1L << 40, 0.5, 1e-30, -1e308, 5e-324, Double.NaN, Double.NEGATIVE_INFINITY,
                true, null, "", " ", "~", "a\nb", "true", "null", "12", "1e3", ".inf", "rk4", "cloth[1,2]", "#00ff00",
                "a: b", "it's", "\"", "\\", "\u00e4\u2028\ud83d\ude00", "- x", "x,y", "y", "a b", "a.",
                Map.of("a", Map.of(), "b", List.of(), "two words", shared, "again", shared));
        String text = BrokenText.text(tree);
        assertEquals(1, text.lines().count(), text);
        assertEquals(tree, new Load(LoadSettings.builder().setSchema(new CoreSchema()).build()).loadFromString(text));
    }
}
