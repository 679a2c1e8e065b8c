package particles.output.files;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.Consumer;

/**
 * A file that is written atomically: it has a temporary name in the same folder until {@link #commit} renames it.
 * Closed without commit, it is deleted, and an earlier file of its name stays. A stopping program may close it from
 * another thread.
 */
public final class OutputFile extends OutputStream {
    private static final int BUFFER = 1 << 16;

    private final Path file;
    private final Path part;
    private final Disk disk;
    private final Consumer<OutputFile> whenDone;
    private final OutputStream stream;
    private boolean open = true;

    /** Opens the file under its temporary name; {@code whenDone} is told when it is closed or cannot be opened. */
    OutputFile(Path file, Disk disk, Consumer<OutputFile> whenDone) {
        this.file = file;
        this.disk = disk;
        this.part = partOf(file);
        this.whenDone = whenDone;
        try {
            stream = new BufferedOutputStream(disk.create(part), BUFFER);
        } catch (IOException e) {
            whenDone.accept(this);
            throw new OutputException(file, "write", e);
        }
    }

    /** Writes a whole file on the disk. */
    public static void write(Path file, byte[] bytes) {
        write(file, Disk.REAL, bytes);
    }

    static void write(Path file, Disk disk, byte[] bytes) {
        Whole whole = new Whole();
        StopHook hook = new StopHook(whole::stop);
        try {
            whole.begin(file, disk).writeWhole(bytes);
        } finally {
            hook.close();
        }
    }

    /** A file that a stop removes, whenever it comes: from then on, none is begun. */
    private static final class Whole {
        private Optional<OutputFile> begun = Optional.empty();
        private boolean stopped;

        synchronized OutputFile begin(Path file, Disk disk) {
            if (stopped) {
                throw new CancellationException("the program is being stopped");
            }
            OutputFile one = new OutputFile(file, disk, done -> { });
            begun = Optional.of(one);
            return one;
        }

        synchronized void stop() {
            stopped = true;
            begun.ifPresent(OutputFile::close);
        }
    }

    /** Writes all bytes of the file, and completes it. */
    public void writeWhole(byte[] bytes) {
        try (OutputFile whole = this) {
            whole.write(bytes, 0, bytes.length);
            whole.commit();
        }
    }

    /** The temporary name: hidden, with a prefix and suffix that the user's own files do not have. */
    static Path partOf(Path file) {
        return file.resolveSibling("." + file.getFileName() + ".part");
    }

    /** @return the final path */
    public Path getPath() {
        return file;
    }

    @Override
    public synchronized void write(int b) {
        attempt(() -> stream.write(b));
    }

    @Override
    public synchronized void write(byte[] bytes, int offset, int length) {
        attempt(() -> stream.write(bytes, offset, length));
    }

    /**
     * Overwrites bytes written before, for formats whose header contains the length.
     *
     * @param position the position of the first of them
     * @param bytes    the new bytes, within what was written
     */
    public synchronized void overwrite(long position, byte[] bytes) {
        attempt(() -> {
            stream.flush();
            try (FileChannel channel = FileChannel.open(part, StandardOpenOption.WRITE)) {
                ByteBuffer rest = ByteBuffer.wrap(bytes);
                while (rest.hasRemaining()) {
                    channel.write(rest, position + rest.position());
                }
            }
        });
    }

    /** Copies all bytes written so far to another file. */
    public synchronized void copyTo(OutputFile other) {
        attempt(() -> {
            stream.flush();
            Files.copy(part, other);
        });
    }

    @Override
    public synchronized void flush() {
        attempt(stream::flush);
    }

    /**
     * Completes the file: renames it to its final name atomically.
     *
     * @throws OutputException if that fails; no file is left then
     */
    public synchronized void commit() {
        attempt(() -> {
            stream.close();
            if (Files.isDirectory(file, LinkOption.NOFOLLOW_LINKS)) {
                throw new IOException("a folder is where the file should be");
            }
            disk.rename(part, file);
        });
        open = false;
        whenDone.accept(this);
    }

    /** Closes the file; without {@link #commit} before, it is deleted. */
    @Override
    public synchronized void close() {
        if (!open) {
            return;
        }
        open = false;
        whenDone.accept(this);
        try {
            try {
                stream.close();
            } catch (IOException e) {                   // its last bytes
                throw new OutputException(file, "write", e);
            } finally {
                Files.deleteIfExists(part);
            }
        } catch (IOException e) {
            throw new OutputException(part, "remove", e);
        }
    }

    @FunctionalInterface
    private interface Action {
        void run() throws IOException;
    }

    /** On failure the file is deleted; a second exception is added to the first as suppressed. */
    private void attempt(Action action) {
        if (!open) {
            throw new OutputException(file, "write", "it was closed before it was complete", null);
        }
        try {
            action.run();
        } catch (IOException e) {
            OutputException failure = new OutputException(file, "write", e);
            try {
                close();
            } catch (OutputException second) {
                failure.addSuppressed(second);
            }
            throw failure;
        }
    }
}
