package hunts;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static particles.Texts.assertStarts;

import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A short hunt. */
class SceneFuzzerTest {
    private static final long SEED = 7;
    private static final int EXECUTIONS = 15_000;

    @Test
    @Tag("slow")
    void aShortHuntFindsNothing(@TempDir Path found) {
        SceneFuzzer fuzzer = new SceneFuzzer(SEED, found);
        assertEquals(0, fuzzer.run(EXECUTIONS, Double.POSITIVE_INFINITY), "the finds are above");
        System.out.println(fuzzer);
        assertStarts(fuzzer.toString(), EXECUTIONS + " executions: ");
    }
}
