package particles;

import static org.junit.jupiter.api.Assertions.assertTrue;

import org.snakeyaml.engine.v2.api.Load;
import org.snakeyaml.engine.v2.api.LoadSettings;

/** Checks of texts: a failure shows the whole text. */
public final class Texts {
    private Texts() {
    }

    /** Checks that a text has all these parts. */
    public static void assertHas(String text, String... parts) {
        for (String part : parts) {
            assertTrue(text.contains(part), () -> "'" + part + "' is not in: " + text);
        }
    }

    /** Checks how a text begins. */
    public static void assertStarts(String text, String start) {
        assertTrue(text.startsWith(start), () -> "not '" + start + "' begins: " + text);
    }

    /** Checks that a regular expression describes the whole text. */
    public static void assertMatches(String text, String regex) {
        assertTrue(text.matches(regex), () -> "'" + regex + "' does not match: " + text);
    }

    /** @return the maps, lists, numbers, booleans and texts in JSON, which is YAML too, or in YAML */
    public static Object json(String text) {
        return new Load(LoadSettings.builder().build()).loadFromString(text);
    }
}
