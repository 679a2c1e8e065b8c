package particles.app.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.stream.Stream;
import particles.output.files.OutputException;
import particles.output.files.OutputFolder;

/** Measures the disk space of a run's results. */
public final class FolderSize {
    /** A smaller size is not reported (bytes). */
    static final long LARGE = 50_000_000;
    private static final long MEGABYTE = 1_000_000;

    private FolderSize() {
    }

    /**
     * @param folder the folder of the results
     * @param option the option that draws frames, as typed
     * @return a line if they are large
     * @throws OutputException if the folder cannot be read
     */
    public static Optional<String> notice(Path folder, String option) {
        long all = bytes(folder);
        Path frames = folder.resolve(OutputFolder.FRAMES);
        long pictures = Files.isDirectory(frames) ? bytes(frames) : 0;
        return all < LARGE ? Optional.empty() : Optional.of("this run wrote " + all / MEGABYTE + " MB"
                + (pictures == 0 ? "" : ", " + pictures / MEGABYTE + " MB of it frames; " + option
                + "=false writes none"));
    }

    private static long bytes(Path folder) {
        try (Stream<Path> files = Files.walk(folder)) {
            return files.filter(Files::isRegularFile).mapToLong(file -> file.toFile().length()).sum();
        } catch (IOException e) {
            throw new OutputException(folder, "read", e);
        }
    }
}
