package particles.app.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class FolderSizeTest {
    /** Files with holes take no room on the disk of the test, but have their length. */
    private static void write(Path file, long bytes) throws IOException {
        try (RandomAccessFile sparse = new RandomAccessFile(file.toFile(), "rw")) {
            sparse.setLength(bytes);
        }
    }

    @Test
    void runsOfMoreThanFiftyMegabytesSaySo(@TempDir Path folder) throws IOException {
        write(folder.resolve("trajectory.csv"), FolderSize.LARGE - 1);
        assertEquals(Optional.empty(), FolderSize.notice(folder, "-Pframes"));
        Files.createDirectories(folder.resolve("frames"));
        write(folder.resolve("frames/frame-00000.png"), 23_500_000);
        assertEquals(Optional.of("this run wrote 73 MB, 23 MB of it frames; -Pframes=false writes none"),
                FolderSize.notice(folder, "-Pframes"));
    }
}
