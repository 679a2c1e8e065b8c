package particles.output.usd;

import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.Map;
import particles.output.files.OutputFile;
import particles.output.files.OutputFolder;

/**
 * The text of a USD stage whose attributes change from frame to frame. The samples of an attribute stand together in
 * the file, so each attribute is collected in a file of its own until the end. A value that stays is written once.
 */
final class UsdStage implements AutoCloseable {
    /** The attribute of all prims that have points. */
    static final String POINTS = "point3f[] points";

    private final OutputFolder folder;
    private final String name;
    private final Map<String, Map<String, Attribute>> prims = new LinkedHashMap<>();
    private int count;

    UsdStage(OutputFolder folder, String name) {
        this.folder = folder;
        this.name = name;
    }

    /** An attribute: the value that it had last, since which frame, and the file of all samples but that one. */
    private static final class Attribute {
        private final OutputFile samples;
        private final String metadata;
        private String value;
        private int since;
        private int last;
        private boolean changes;

        Attribute(OutputFile samples, String metadata, int frame, String value) {
            this.samples = samples;
            this.metadata = metadata;
            this.value = value;
            since = frame;
            last = frame;
        }

        boolean isAlways(String only) {
            return !changes && value.equals(only);
        }

        void put(int frame, String next) {
            if (!next.equals(value)) {
                changes = true;
                writeLast();
                value = next;
                since = frame;
            }
            last = frame;
        }

        /** A reader interpolates between samples, so a value that stayed is written at both ends of that time. */
        private void writeLast() {
            write(since);
            if (last > since) {
                write(last);
            }
        }

        private void write(int frame) {
            UsdStage.write(samples, "            " + frame + ": " + value + ",\n");
        }

        void appendTo(OutputFile out, String declaration) {
            String head = "        " + declaration;
            if (!changes || !metadata.isEmpty()) {
                UsdStage.write(out, head + (changes ? "" : " = " + value) + metadata + "\n");
            }
            if (changes) {
                writeLast();
                UsdStage.write(out, head + ".timeSamples = {\n");
                samples.copyTo(out);
                UsdStage.write(out, "        }\n");
            }
        }
    }

    private static void write(OutputFile out, String text) {
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        out.write(bytes, 0, bytes.length);
    }

    /**
     * Sets an attribute from a frame on.
     *
     * @param prim        the type and name of its prim, such as {@code Mesh "cloth"}
     * @param declaration its type and name
     * @param metadata    more of it, in parentheses; empty for none
     */
    void put(String prim, String declaration, String metadata, int frame, String value) {
        Map<String, Attribute> attributes = prims.computeIfAbsent(prim, key -> new LinkedHashMap<>());
        Attribute known = attributes.get(declaration);
        if (known == null) {
            attributes.put(declaration, new Attribute(folder.createScratch(name + "-" + count++), metadata, frame,
                    value));
        } else {
            known.put(frame, value);
        }
    }

    /** Writes the stage, without prims that never had a point. */
    void finish(String head) {
        try (OutputFile out = folder.create(name)) {
            write(out, head);
            prims.entrySet().removeIf(prim -> prim.getValue().containsKey(POINTS)
                    && prim.getValue().get(POINTS).isAlways("[]"));
            prims.forEach((prim, attributes) -> {
                write(out, "    def " + prim + "\n    {\n");
                attributes.forEach((declaration, attribute) -> attribute.appendTo(out, declaration));
                write(out, "    }\n");
            });
            write(out, "}\n");
            out.commit();
        }
    }

    /** Removes the attributes' own files. */
    @Override
    public void close() {
        prims.values().forEach(attributes -> attributes.values().forEach(attribute -> attribute.samples.close()));
    }
}
