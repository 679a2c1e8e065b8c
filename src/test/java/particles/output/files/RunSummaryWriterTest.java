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
import java.util.stream.Collectors;
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
        assertEquals("""
                deltaT 0.1
                duration 10.0
                endTime 9.9
                energy.end 1.5
                energy.largestRelativeDrift 0.25
                energy.largestRelativeNumericalError 0.125
                energy.numericalError 0.125
                energy.relativeDrift -0.125
                energy.relativeNumericalError 0.03125
                energy.scale 4.0
                energy.start 2.0
                evaluations 396
                scene one "spring"
                sceneSha256 ab12
                secondsTaken 0.25
                solver rk4
                steps 99
                version 1.0
                work.airDrag (dissipated) -0.625
                """, values.entrySet().stream().filter(entry -> !entry.getKey().startsWith("java.")).sorted(
                        Map.Entry.comparingByKey()).map(entry -> entry.getKey() + " " + entry.getValue() + "\n")
                .collect(Collectors.joining()));
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
