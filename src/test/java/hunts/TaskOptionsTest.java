package hunts;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import org.junit.jupiter.api.Test;

/** Options of tasks that are not commands of the program, and their error messages. */
class TaskOptionsTest {
    private static final List<String> NAMES = List.of("seconds", "seed");

    private static String refusal(List<String> allowed, String... args) {
        return assertThrows(IllegalArgumentException.class, () -> new TaskOptions(args, allowed)).getMessage();
    }

    @Test
    void givenOptionsAreUsedAndOthersHaveDefaults() {
        TaskOptions options = new TaskOptions(new String[] {"--seed=7", "--seconds=a=b"}, NAMES);
        assertEquals(7, options.getCount("seed", 1));
        assertEquals("a=b", options.get("seconds", "60"), "the first = ends the name");
        assertEquals("60", new TaskOptions(new String[0], NAMES).get("seconds", "60"));
        assertEquals(1, new TaskOptions(new String[0], NAMES).getCount("seed", 1));
    }

    @Test
    void unknownNamesAreRefusedWithTheKnownOnes() {
        assertEquals("unknown option -Psed; did you mean -Pseed? allowed: -Pseconds, -Pseed",
                refusal(NAMES, "--sed=7"));
        assertEquals("option -Pseed needs a value: -Pseed=...", refusal(NAMES, "--seed"));
        assertEquals("unknown option -Pseed; this task has none", refusal(List.of(), "--seed=7"));
    }

    @Test
    void aCountIsAWholeNumber() {
        for (String text : List.of("", "-1", "1.5", "1e3", "1234567890123456789")) {
            TaskOptions options = new TaskOptions(new String[] {"--seed=" + text}, NAMES);
            String message = assertThrows(IllegalArgumentException.class,
                    () -> options.getCount("seed", 1)).getMessage();
            assertEquals("-Pseed has to be a whole number, not '" + text + "'", message);
        }
    }
}
