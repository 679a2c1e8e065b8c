package particles.output.files;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;

/**
 * A file that comes to be as a whole or not at all: it is written under a temporary name in the same folder and moved
 * to its own name by {@link #commit}. Closed without commit, it leaves nothing behind, and a file that was there before
 * stays. May be closed by another thread than the one that writes, as a program does that is being stopped.
 */
public final class OutputFile extends OutputStream {
    private static final int BUFFER = 1 << 16;

    /** How a file is opened; tests put a full disk here. */
    @FunctionalInterface
    public interface Opener {
        OutputStream open(Path file) throws IOException;
    }

    /** Never through a link: a file of that name that was there is removed, not written to. */
    public static final Opener ON_DISK = file -> {
        Files.deleteIfExists(file);
        return Files.newOutputStream(file, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
    };

    private final Path file;
    private final Path part;
    private final Runnable whenDone;
    private final OutputStream stream;
    private boolean open = true;

    public OutputFile(Path file, Opener opener, Runnable whenDone) {
        this.file = file;
        this.part = partOf(file);
        this.whenDone = whenDone;
        try {
            stream = new BufferedOutputStream(opener.open(part), BUFFER);
        } catch (IOException e) {
            whenDone.run();
            throw new OutputException(file, "write", e);
        }
    }

    /** The temporary name: hidden, and told from the user's own files by both ends. */
    static Path partOf(Path file) {
        return file.resolveSibling("." + file.getFileName() + ".part");
    }

    /** @return where the file will be */
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
     * Writes over bytes that were written before, as formats want it whose beginning tells the length.
     *
     * @param position of the first of them
     * @param bytes    what is to be there; it ends where what was written ends, or before
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

    @Override
    public synchronized void flush() {
        attempt(stream::flush);
    }

    /**
     * The file is complete: gives it its name, in one move that replaces what was there.
     *
     * @throws OutputException if that fails; nothing is left then
     */
    public synchronized void commit() {
        attempt(() -> {
            stream.close();
            if (Files.isDirectory(file, LinkOption.NOFOLLOW_LINKS)) {
                throw new IOException("a folder is where the file should be");
            }
            Files.move(part, file, StandardCopyOption.ATOMIC_MOVE);
        });
        open = false;
        whenDone.run();
    }

    /** Ends the writing; without {@link #commit} before, what was written is thrown away. */
    @Override
    public synchronized void close() {
        if (!open) {
            return;
        }
        open = false;
        whenDone.run();
        try {
            try {
                stream.close();
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

    /** On failure nothing is left behind; the first exception tells the reason, a second one rides along. */
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
