package particles.output;

import java.io.BufferedOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.Consumer;
import java.util.zip.CRC32;
import java.util.zip.CheckedOutputStream;
import particles.Memory;

/**
 * The file from which an interrupted run is continued: what run it is of, and all that it has to remember. Like every
 * other file it is there as a whole or not at all, and the one before stays until then; it ends with a checksum.
 */
public final class Checkpoint {
    /** The file's name. */
    public static final String FILE = "checkpoint";
    private static final byte[] HEAD = "DESolver checkpoint 1\n".getBytes(StandardCharsets.US_ASCII);

    private final Map<String, String> identity;
    private final ReadingMemory memory;

    private Checkpoint(Map<String, String> identity, ReadingMemory memory) {
        this.identity = identity;
        this.memory = memory;
    }

    /**
     * Writes one, in the place of the one before.
     *
     * @param folder   where
     * @param identity what the run is: names and values, which a run that continues it has to have as well
     * @param contents passes everything through a memory
     * @throws OutputException if it cannot be written; the one before stands then
     */
    public static void write(OutputFolder folder, Map<String, String> identity, Consumer<Memory> contents) {
        CRC32 sum = new CRC32();
        try (OutputFile file = folder.create(FILE)) {
            DataOutputStream out = new DataOutputStream(new BufferedOutputStream(new CheckedOutputStream(file, sum)));
            out.write(HEAD);
            WritingMemory memory = new WritingMemory(out);
            memory.keep(identity.size());
            identity.forEach((name, value) -> {
                memory.keep(name);
                memory.keep(value);
            });
            contents.accept(memory);
            out.flush();
            out.writeLong(sum.getValue());
            out.flush();
            file.commitSafely();
        } catch (IOException e) {
            throw new UncheckedIOException(e);      // of the streams around the file, whose own are OutputExceptions
        }
    }

    /**
     * @param folder the folder of a run
     * @return whether a run that can be continued is there
     */
    public static boolean isIn(Path folder) {
        return Files.isRegularFile(folder.resolve(FILE), LinkOption.NOFOLLOW_LINKS);
    }

    /**
     * Reads one.
     *
     * @param folder the folder of the run
     * @return the checkpoint
     * @throws OutputException if it cannot be read or is damaged
     */
    public static Checkpoint read(Path folder) {
        Path file = folder.resolve(FILE);
        try {
            byte[] bytes = Files.readAllBytes(file);
            int end = bytes.length - Long.BYTES;
            if (end < HEAD.length || !Arrays.equals(HEAD, 0, HEAD.length, bytes, 0, HEAD.length)
                    || checksum(bytes, end) != ByteBuffer.wrap(bytes).getLong(end)) {
                throw new OutputException(file, "continue from", "it is damaged; the run has to begin anew", null);
            }
            ReadingMemory memory = new ReadingMemory(ByteBuffer.wrap(bytes, HEAD.length, end - HEAD.length));
            Map<String, String> identity = new LinkedHashMap<>();
            int count = memory.keep(0);
            for (int k = 0; k < count; k++) {
                identity.put(memory.keep(""), memory.keep(""));
            }
            return new Checkpoint(identity, memory);
        } catch (IOException e) {
            throw new OutputException(file, "read", e);
        }
    }

    private static long checksum(byte[] bytes, int length) {
        CRC32 sum = new CRC32();
        sum.update(bytes, 0, length);
        return sum.getValue();
    }

    /** @return what run it is of, as it was given when it was written */
    public Map<String, String> getIdentity() {
        return identity;
    }

    /** @return what the run remembers, to be read once */
    public Memory getMemory() {
        return memory;
    }
}
