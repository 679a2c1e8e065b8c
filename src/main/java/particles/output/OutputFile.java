package particles.output;

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
    interface Opener {
        OutputStream open(Path file) throws IOException;

        /** Opens a file that is there, to go on after its first bytes. */
        default OutputStream openAfter(Path file, long length) throws IOException {
            try (FileChannel channel = FileChannel.open(file, StandardOpenOption.WRITE, LinkOption.NOFOLLOW_LINKS)) {
                channel.truncate(length);
            }
            return Files.newOutputStream(file, StandardOpenOption.APPEND, LinkOption.NOFOLLOW_LINKS);
        }
    }

    /** Never through a link: a file of that name that was there is removed, not written to. */
    static final Opener ON_DISK = file -> {
        Files.deleteIfExists(file);
        return Files.newOutputStream(file, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
    };

    private final Path file;
    private final Path part;
    private final Runnable whenDone;
    private final OutputStream stream;
    private long written;
    private long safe;                                  // bytes from which the writing can be continued, 0 for none
    private boolean open = true;

    OutputFile(Path file, Opener opener, Runnable whenDone) {
        this(file, opener, 0, whenDone);
    }

    /** Goes on with what an earlier run has written under the temporary name, after its first bytes. */
    OutputFile(Path file, Opener opener, long written, Runnable whenDone) {
        this.file = file;
        this.part = partOf(file);
        this.written = written;
        this.safe = written;
        this.whenDone = whenDone;
        try {
            stream = new BufferedOutputStream(written == 0 ? opener.open(part) : opener.openAfter(part, written), BUFFER);
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
        written++;
    }

    @Override
    public synchronized void write(byte[] bytes, int offset, int length) {
        attempt(() -> stream.write(bytes, offset, length));
        written += length;
    }

    /**
     * Writes over bytes that were written before, as formats want it whose beginning tells the length.
     *
     * @param position of the first of them
     * @param bytes    what is to be there; it ends where what was written ends, or before
     */
    synchronized void overwrite(long position, byte[] bytes) {
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
     * Brings what was written so far safely to the disk, also for the case that the power fails. From now on so much stays
     * under the temporary name when the file is closed without commit, so that the writing can be continued.
     *
     * @return how many bytes that are
     */
    public synchronized long sync() {
        attempt(() -> {
            stream.flush();
            force();
        });
        safe = written;
        return written;
    }

    /**
     * The file is complete: gives it its name, in one move that replaces what was there.
     *
     * @throws OutputException if that fails; nothing is left then
     */
    public synchronized void commit() {
        commit(false);
    }

    /**
     * The same, with the file on the disk before it has its name, also for the case that the power fails.
     *
     * @throws OutputException if that fails; nothing is left then
     */
    public synchronized void commitSafely() {
        commit(true);
    }

    private void commit(boolean safely) {
        attempt(() -> {
            stream.flush();
            if (safely) {
                force();
            }
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
                discard();
            }
        } catch (IOException e) {
            throw new OutputException(part, "remove", e);
        }
    }

    private void force() throws IOException {
        try (FileChannel channel = FileChannel.open(part, StandardOpenOption.WRITE)) {
            channel.force(false);
        }
    }

    private void discard() throws IOException {
        if (safe == 0) {
            Files.deleteIfExists(part);
        } else if (Files.exists(part)) {
            try (FileChannel channel = FileChannel.open(part, StandardOpenOption.WRITE)) {
                channel.truncate(safe);
            }
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
