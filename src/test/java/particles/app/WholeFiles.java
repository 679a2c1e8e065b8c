package particles.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.jcodec.common.io.ByteBufferSeekableByteChannel;
import org.jcodec.containers.mp4.demuxer.MP4Demuxer;
import particles.Texts;
import particles.spec.Digest;

/** Checks the result files of a run: each is complete, and folders have equal files. */
final class WholeFiles {
    private static final byte[] PNG_END = {'I', 'E', 'N', 'D', (byte) 0xae, 0x42, 0x60, (byte) 0x82};
    private static final byte[] GIF_END = {0, 0x3b};

    private WholeFiles() {
    }

    /** Checks every file except hidden leftovers of a killed program. */
    static void assertWhole(Path folder) throws IOException {
        for (Path file : files(folder)) {
            String name = file.getFileName().toString();
            if (name.endsWith(".part")) {
                continue;
            }
            byte[] bytes = Files.readAllBytes(file);
            if (name.endsWith(".png")) {
                assertEnds(PNG_END, bytes, name);
                assertTrue(ImageIO.read(file.toFile()).getWidth() > 0, name);
            } else if (name.endsWith(".gif")) {
                assertEnds(GIF_END, bytes, name);
            } else if (name.endsWith(".mp4")) {
                try (MP4Demuxer film = MP4Demuxer.createMP4Demuxer(
                        new ByteBufferSeekableByteChannel(ByteBuffer.wrap(bytes),
                        bytes.length))) {
                    assertTrue(film.getVideoTrack().getMeta().getTotalFrames() > 0, name);
                }
            } else if (name.equals("trajectory.csv")) {
                String text = new String(bytes, StandardCharsets.UTF_8);
                assertTrue(text.endsWith("\n") && text.lines().allMatch(line -> line.replaceAll("\"[^\"]*\"",
                        "id").split(",").length == 8), name);
            } else if (name.equals("run.json")) {
                assertTrue(Texts.json(new String(bytes, StandardCharsets.UTF_8)) instanceof Map, name);
            } else if (name.equals(".desolver-writing")) {
                assertTrue(new String(bytes, StandardCharsets.US_ASCII).matches("\\d*"), name);
            } else {
                assertEquals(".desolver-made", name, "an unknown file");
                assertTrue(new String(bytes, StandardCharsets.UTF_8).endsWith("\n"), name);
            }
        }
    }

    private static void assertEnds(byte[] end, byte[] bytes, String name) {
        assertTrue(bytes.length >= end.length, name);
        assertEquals(HexFormat.of().formatHex(end),
                HexFormat.of().formatHex(Arrays.copyOfRange(bytes, bytes.length - end.length, bytes.length)), name);
    }

    private static List<Path> files(Path folder) throws IOException {
        if (!Files.exists(folder)) {
            return List.of();
        }
        try (Stream<Path> files = Files.walk(folder)) {
            return files.filter(Files::isRegularFile).toList();
        }
    }

    /**
     * Names and SHA-256 of all results, of run.json without the time that the run took, of a film without its dates.
     */
    static Map<String, String> sums(Path folder) throws IOException {
        Map<String, String> sums = new TreeMap<>();
        for (Path file : files(folder)) {
            byte[] bytes = Files.readAllBytes(file);
            if (file.endsWith("run.json")) {
                bytes = new String(bytes, StandardCharsets.UTF_8).replaceAll("\"secondsTaken\" : [^,]*", "")
                        .getBytes(StandardCharsets.UTF_8);
            }
            if (file.toString().endsWith(".mp4")) {
                blankDates(bytes);
            }
            sums.put(folder.relativize(file).toString(),
                    Digest.of(new String(bytes, StandardCharsets.ISO_8859_1)));
        }
        return sums;
    }

    /** When it was made and when it was changed stands after the names and versions of three of the format's boxes. */
    private static void blankDates(byte[] film) {
        String text = new String(film, StandardCharsets.ISO_8859_1);
        for (String box : List.of("mvhd", "tkhd", "mdhd")) {
            int at = text.lastIndexOf(box) + 8;
            Arrays.fill(film, at, at + 8, (byte) 0);
        }
    }
}
