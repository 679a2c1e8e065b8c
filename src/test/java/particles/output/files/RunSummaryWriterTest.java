package particles.output.files;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonToken;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The contents of run.json, read back by a JSON parser. */
class RunSummaryWriterTest {
    @TempDir
    Path top;

    private Map<String, String> readBack(RunSummary run) throws IOException {
        RunSummaryWriter.write(OutputFolder.open(top), run);
        Map<String, String> values = new LinkedHashMap<>();
        try (JsonParser json = new JsonFactory().createParser(Files.readString(top.resolve("run.json")))) {
            String path = "";
            while (json.nextToken() != null) {
                if (json.currentToken().isScalarValue()) {
                    values.put(path + json.currentName(), json.getText());
                } else if (json.currentToken() == JsonToken.START_OBJECT && json.currentName() != null) {
                    path = json.currentName() + ".";
                } else if (json.currentToken() == JsonToken.END_OBJECT) {
                    path = "";
                }
            }
        }
        return values;
    }

    @Test
    void everyValueReadsBack() throws IOException {
        Map<String, String> values = readBack(new RunSummary("one \"spring\"", "ab12", "rk4", 0.1, 10, 9.9, "1.0", 99,
                396,
                0.25, 2, 1.5, 4, 1, Map.of("airDrag (dissipated)", -0.625), 0.125, 0.5));
        assertEquals("one \"spring\"", values.get("scene"));
        assertEquals("ab12", values.get("sceneSha256"));
        assertEquals("rk4", values.get("solver"));
        assertEquals("0.1", values.get("deltaT"));
        assertEquals("10.0", values.get("duration"));
        assertEquals("9.9", values.get("endTime"));
        assertEquals("99", values.get("steps"));
        assertEquals("396", values.get("evaluations"));
        assertEquals("0.25", values.get("secondsTaken"));
        assertEquals("2.0", values.get("energy.start"));
        assertEquals("1.5", values.get("energy.end"));
        assertEquals("4.0", values.get("energy.scale"));
        assertEquals("-0.125", values.get("energy.relativeDrift"));
        assertEquals("0.25", values.get("energy.largestRelativeDrift"));
        assertEquals("-0.625", values.get("work.airDrag (dissipated)"));
        assertEquals("0.125", values.get("energy.numericalError"));
        assertEquals("0.03125", values.get("energy.relativeNumericalError"));
        assertEquals("0.125", values.get("energy.largestRelativeNumericalError"));
        assertEquals(Runtime.version().toString(), values.get("java.version"));
    }

    @Test
    void nonFiniteNumbersAreNull() throws IOException {
        Map<String, String> values = readBack(new RunSummary("s", "h", "euler", 1, 1, 1, "1", 1, 1, 1, 0,
                Double.POSITIVE_INFINITY, 1, Double.NaN, Map.of(), Double.NaN, Double.NaN));
        assertEquals("null", values.get("energy.end"));
        assertEquals("null", values.get("energy.relativeDrift"));
        assertTrue(Files.readString(top.resolve("run.json")).endsWith("}\n"));
    }

    @Test
    void aSceneAtRestHasNoDrift() {
        assertEquals(0, new RunSummary("s", "h", "euler", 1, 1, 1, "1", 1, 1, 1, 3, 3, 0, 0, Map.of(), 0,
                0).relativeDrift());
    }
}
