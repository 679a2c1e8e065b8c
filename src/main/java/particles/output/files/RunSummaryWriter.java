package particles.output.files;

import com.fasterxml.jackson.core.JsonEncoding;
import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.StreamWriteFeature;
import com.fasterxml.jackson.core.util.DefaultIndenter;
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Map;

/** Writes {@code run.json}. NaN and infinity are written as {@code null}, since JSON cannot express them. */
public final class RunSummaryWriter {
    /** The file's name. */
    public static final String FILE = "run.json";

    private RunSummaryWriter() {
    }

    /**
     * @param folder the output folder
     * @param run    the summary
     * @throws OutputException if it cannot be written
     */
    public static void write(OutputFolder folder, RunSummary run) {
        JsonFactory factory = JsonFactory.builder().enable(StreamWriteFeature.USE_FAST_DOUBLE_WRITER).build();
        DefaultIndenter indenter = new DefaultIndenter("  ", "\n");
        try (OutputFile file = folder.create(FILE);
                JsonGenerator json = factory.createGenerator(file, JsonEncoding.UTF8)) {
            json.setPrettyPrinter(new DefaultPrettyPrinter().withObjectIndenter(indenter));
            write(json, run);
            json.writeRaw('\n');
            json.flush();
            file.commit();
        } catch (IOException e) {
            throw new UncheckedIOException(e);      // from the generator; the file itself throws OutputExceptions
        }
    }

    private static void write(JsonGenerator json, RunSummary run) throws IOException {
        json.writeStartObject();
        fields(json, "version", run.version(), "scene", run.scene(), "sceneSha256", run.sceneHash(),
                "solver", run.solver(), "deltaT", run.deltaT(), "duration", run.duration(), "endTime", run.endTime(),
                "steps", run.steps(), "evaluations", run.evaluations(), "secondsTaken", run.secondsTaken());
        json.writeObjectFieldStart("energy");
        fields(json, "start", run.startEnergy(), "end", run.endEnergy(), "scale", run.energyScale(),
                "relativeDrift", run.relativeDrift(), "largestRelativeDrift", run.largestRelativeDrift(),
                "numericalError", run.numericalError(), "relativeNumericalError", run.relativeNumericalError(),
                "largestRelativeNumericalError", run.largestRelativeNumericalError());
        json.writeObjectFieldStart("work");
        for (Map.Entry<String, Double> kind : run.work().entrySet()) {
            fields(json, kind.getKey(), kind.getValue());
        }
        json.writeEndObject();
        json.writeEndObject();
        json.writeObjectFieldStart("java");
        fields(json, "version", Runtime.version().toString(), "vendor", System.getProperty("java.vendor", ""),
                "machine", System.getProperty("java.vm.name", ""));
        json.writeEndObject();
        json.writeEndObject();
    }

    /** Writes names and values in turn; NaN and infinity are null. */
    private static void fields(JsonGenerator json, Object... namesAndValues) throws IOException {
        for (int k = 0; k < namesAndValues.length; k += 2) {
            Object value = namesAndValues[k + 1];
            json.writeFieldName((String) namesAndValues[k]);
            json.writeObject(value instanceof Double number && !Double.isFinite(number) ? null : value);
        }
    }
}
