package particles.output.files;

import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.stream.Stream;

/** A folder for a while: it is deleted with all that is in it, even if the program is stopped. */
public final class TemporaryFolder implements AutoCloseable {
    /** While the program is being stopped, another thread may put something into it once more. */
    private static final int TRIES = 3;

    private final StopHook hook = new StopHook(this::close);
    private Optional<Path> made = Optional.empty();
    private boolean closed;

    /**
     * @param name the beginning of its name
     * @throws IOException           if it cannot be made
     * @throws CancellationException if the program is being stopped
     */
    public TemporaryFolder(String name) throws IOException {
        synchronized (this) {                           // the hook may have run already
            if (closed) {
                throw new CancellationException(name);
            }
            made = Optional.of(Files.createTempDirectory(name));
        }
    }

    /** @return its path */
    public synchronized Path getPath() {
        return made.orElseThrow();
    }

    @Override
    public synchronized void close() {
        closed = true;
        made.ifPresent(TemporaryFolder::delete);
        hook.close();
    }

    /**
     * Deletes a folder and all that is in it; what cannot be deleted stays.
     *
     * @param folder the folder
     */
    public static void delete(Path folder) {
        for (int i = 0; i < TRIES && Files.exists(folder); i++) {
            try (Stream<Path> all = Files.walk(folder)) {
                all.sorted(Comparator.reverseOrder()).map(Path::toFile).forEach(File::delete);
            } catch (IOException | UncheckedIOException e) {
                return;                                 // a student's class made a folder that cannot be listed
            }
        }
    }
}
