package particles.app;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonToken;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import particles.output.OutputException;
import particles.output.RunSummaryWriter;

/** Whether a folder holds a run that came to its end. */
final class FinishedRun {
    private static final double ROUNDING = 1e-9;

    private FinishedRun() {
    }

    /** @return whether the summary there says so; false where there is none */
    static boolean isIn(Path results) {
        Path file = results.resolve(RunSummaryWriter.FILE);
        if (!Files.isRegularFile(file)) {
            return false;
        }
        double duration = Double.NaN;
        double endTime = Double.NaN;
        try (JsonParser json = new JsonFactory().createParser(file.toFile())) {
            while (json.nextToken() != null) {
                if (json.currentToken() == JsonToken.VALUE_NUMBER_FLOAT || json.currentToken() == JsonToken.VALUE_NUMBER_INT) {
                    duration = json.currentName().equals("duration") ? json.getDoubleValue() : duration;
                    endTime = json.currentName().equals("endTime") ? json.getDoubleValue() : endTime;
                }
            }
        } catch (IOException e) {
            throw new OutputException(file, "read", e);
        }
        return endTime >= duration * (1 - ROUNDING);
    }
}
