package particles.spec.documents;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.io.NumberOutput;
import com.fasterxml.jackson.core.util.DefaultIndenter;
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter;
import deSolvers.text.Digits;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.math.BigDecimal;
import java.util.List;
import java.util.Map;
import particles.spec.MappingType;
import particles.spec.Ordered;

/**
 * Writes indented JSON. NaN and infinity are written as {@code null}, since JSON cannot express them; other numbers by
 * one fixed algorithm, the same on every JDK.
 */
public final class JsonText {
    private JsonText() {
    }

    /**
     * @param value maps with texts as keys, lists, numbers, booleans and texts
     * @return the text, ending with a line feed
     */
    public static String of(Map<String, Object> value) {
        StringWriter text = new StringWriter();
        try (JsonGenerator json = new JsonFactory().createGenerator(text)) {
            DefaultIndenter indenter = new DefaultIndenter("  ", "\n");
            json.setPrettyPrinter(new DefaultPrettyPrinter().withObjectIndenter(indenter).withArrayIndenter(indenter));
            write(value, json);
        } catch (IOException e) {
            throw new UncheckedIOException("writing into memory failed", e);
        }
        return text.append('\n').toString();
    }

    /**
     * Writes a type as a JSON Schema of draft 7, the newest draft that the YAML plug-ins of all common editors know.
     *
     * @param root        the type of a whole file
     * @param title       the title of such a file
     * @param description a description of the schema's origin
     * @return the schema; the same text for the same type, always
     */
    public static String schema(MappingType root, String title, String description) {
        Map<String, Object> schema = Ordered.map("$schema", "http://json-schema.org/draft-07/schema#", "title", title,
                "description", description);
        schema.putAll(root.schema());
        return of(schema);
    }

    private static void write(Object value, JsonGenerator json) throws IOException {
        if (value instanceof Map<?, ?> map) {
            json.writeStartObject();
            for (Map.Entry<?, ?> entry : map.entrySet()) {
                json.writeFieldName((String) entry.getKey());
                write(entry.getValue(), json);
            }
            json.writeEndObject();
        } else if (value instanceof List<?> list) {
            json.writeStartArray();
            for (Object element : list) {
                write(element, json);
            }
            json.writeEndArray();
        } else if (value instanceof Double number) {
            if (Double.isFinite(number)) {
                json.writeNumber(Digits.exact(new BigDecimal(NumberOutput.toString(number, true))));
            } else {
                json.writeNull();
            }
        } else {
            json.writeObject(value);
        }
    }
}
