package particles.spec;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

class JsonTextTest {

    /** JSON has no NaN and no infinity; whole numbers have no point, and -0 is one of them. */
    @Test
    void numbersAreWrittenAsJsonCanReadThem() {
        assertEquals("""
                {
                  "numbers" : [
                    3,
                    0,
                    0.1,
                    1e30,
                    null,
                    null
                  ],
                  "flag" : true,
                  "none" : [ ]
                }
                """, JsonText.of(JsonText.map("numbers", List.of(3.0, -0.0, 0.1, 1e30, Double.NaN,
                Double.NEGATIVE_INFINITY), "flag", true, "none", List.of())));
    }

    @Test
    void textsAndNumbersAreWrittenInOneLine() {
        assertEquals("{\"a\":[1,0.5,null,true,\"x\\\\\\u000a\\\"\"]}",
                JsonText.compact(Map.of("a", List.of(1, 0.5, Double.NaN, true, "x\\\n\""))));
    }
}
