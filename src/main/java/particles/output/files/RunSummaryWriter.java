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
        json.writeStringField("version", run.version());
        json.writeStringField("scene", run.scene());
        json.writeStringField("sceneSha256", run.sceneHash());
        json.writeStringField("solver", run.solver());
        number(json, "deltaT", run.deltaT());
        number(json, "duration", run.duration());
        number(json, "endTime", run.endTime());
        json.writeNumberField("steps", run.steps());
        json.writeNumberField("evaluations", run.evaluations());
        number(json, "secondsTaken", run.secondsTaken());
        json.writeObjectFieldStart("energy");
        number(json, "start", run.startEnergy());
        number(json, "end", run.endEnergy());
        number(json, "scale", run.energyScale());
        number(json, "relativeDrift", run.relativeDrift());
        number(json, "largestRelativeDrift", run.largestRelativeDrift());
        number(json, "numericalError", run.numericalError());
        number(json, "relativeNumericalError", run.relativeNumericalError());
        number(json, "largestRelativeNumericalError", run.largestRelativeNumericalError());
        json.writeObjectFieldStart("work");
        for (Map.Entry<String, Double> kind : run.work().entrySet()) {
            number(json, kind.getKey(), kind.getValue());
        }
        json.writeEndObject();
        json.writeEndObject();
        json.writeObjectFieldStart("java");
        json.writeStringField("version", Runtime.version().toString());
        json.writeStringField("vendor", System.getProperty("java.vendor", ""));
        json.writeStringField("machine", System.getProperty("java.vm.name", ""));
        json.writeEndObject();
        json.writeEndObject();
    }

    private static void number(JsonGenerator json, String name, double value) throws IOException {
        if (Double.isFinite(value)) {
            json.writeNumberField(name, value);
        } else {
            json.writeNullField(name);
        }
    }
}
