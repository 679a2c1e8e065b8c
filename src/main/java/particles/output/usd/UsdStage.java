package particles.output.usd;

import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.Map;
import particles.output.files.OutputFile;
import particles.output.files.OutputFolder;

/**
 * The text of a USD stage whose attributes change from frame to frame. The samples of an attribute stand together in
 * the file, so each attribute is collected in a file of its own until the end. A value that stays is not repeated.
 */
final class UsdStage implements AutoCloseable {
    /** The attribute of all prims that have points. */
    static final String POINTS = "point3f[] points";

    private final OutputFolder folder;
    private final String name;
    private final Map<String, Map<String, Samples>> prims = new LinkedHashMap<>();
    private int count;

    UsdStage(OutputFolder folder, String name) {
        this.folder = folder;
        this.name = name;
    }

    /** The samples of an attribute so far. */
    private static final class Samples {
        private final OutputFile file;
        private String value = "";
        private int last;
        private boolean empty = true;

        Samples(OutputFile file) {
            this.file = file;
        }

        /** A reader interpolates between samples, so a value that stayed is written again just before it changes. */
        void put(int frame, String next) {
            if (!next.equals(value)) {
                if (!value.isEmpty() && last < frame - 1) {
                    write(frame - 1);
                }
                value = next;
                empty &= value.equals("[]");
                write(frame);
                last = frame;
            }
        }

        private void write(int frame) {
            UsdStage.write(file, "            " + frame + ": " + value + ",\n");
        }
    }

    private static void write(OutputFile out, String text) {
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        out.write(bytes, 0, bytes.length);
    }

    /**
     * Sets an attribute from a frame on.
     *
     * @param prim      the text with which its prim begins: the type and name, and attributes that never change
     * @param attribute its type and name
     */
    void put(String prim, String attribute, int frame, String value) {
        prims.computeIfAbsent(prim, key -> new LinkedHashMap<>()).computeIfAbsent(attribute,
                key -> new Samples(folder.createScratch(name + "-" + count++))).put(frame, value);
    }

    /** Writes the stage, without prims that never had a point. */
    void finish(String head) {
        try (OutputFile out = folder.create(name)) {
            write(out, head);
            prims.forEach((prim, attributes) -> {
                if (!attributes.get(POINTS).empty) {
                    write(out, prim);
                    attributes.forEach((attribute, samples) -> {
                        write(out, "        " + attribute + ".timeSamples = {\n");
                        samples.file.copyTo(out);
                        write(out, "        }\n");
                    });
                    write(out, "    }\n");
                }
            });
            write(out, "}\n");
            out.commit();
        }
    }

    /** Removes the attributes' own files. */
    @Override
    public void close() {
        prims.values().forEach(attributes -> attributes.values().forEach(samples -> samples.file.close()));
    }
}
