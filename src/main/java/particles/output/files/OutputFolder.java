package particles.output.files;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CancellationException;

/**
 * The folder of a run's results. A small hidden file lists the names of its files, so that a new run removes only files
 * of an old one; a file of the same name that no run made is never overwritten. Every file is written whole or not at
 * all. Nothing outside the folder is touched.
 */
public final class OutputFolder implements AutoCloseable {
    /** The folder of the frames, in the output folder. */
    public static final String FRAMES = "frames";

    private final Path path;
    private final Disk disk;
    private final OutputManifest made;
    private final StopHook hook = new StopHook(this::stop);
    private final Set<OutputFile> unfinished = new LinkedHashSet<>();
    private Optional<FolderLock> lock = Optional.empty();
    private boolean closed;
    private volatile Runnable whenStopped = () -> { };

    private OutputFolder(Path path, Disk disk) {
        this.path = path;
        this.disk = disk;
        this.made = new OutputManifest(path, disk);
        synchronized (this) {
            if (closed) {                               // by the hook
                throw new CancellationException("the program is being stopped");
            }
            try {
                lock = Optional.of(FolderLock.of(path, disk));
            } catch (OutputException e) {
                hook.close();
                throw e;
            }
        }
    }

    /**
     * Creates the folder, or removes the files of a previous run from it.
     *
     * @param path the folder
     * @param names the files that will be written, checked before a long run begins; {@link #FRAMES} for frames; others
     *              may follow
     * @return the folder, ready to be written to
     * @throws OutputException if it cannot be created or written, another run is writing there, or it holds a file of
     *                         these names that no run made
     */
    public static OutputFolder open(Path path, String... names) {
        return open(path, Disk.REAL, names);
    }

    /** As {@link #open(Path, String...)}, on another disk. */
    public static OutputFolder open(Path path, Disk disk, String... names) {
        createFolder(path);
        OutputFolder folder = new OutputFolder(path, disk);
        try {
            folder.made.removeOldRun();
            for (String name : names) {
                folder.made.claim(name);
            }
            folder.made.write();
            if (folder.made.contains(FRAMES)) {
                createFolder(path.resolve(FRAMES));
            }
            return folder;
        } catch (RuntimeException e) {
            folder.close();
            throw e;
        }
    }

    /**
     * @param path a folder
     * @return the names of the files that a run made there, in the order of creation; empty if no run did
     * @throws IOException if that cannot be read
     */
    public static List<String> made(Path path) throws IOException {
        return OutputManifest.names(path);
    }

    private static void createFolder(Path path) {
        try {
            Files.createDirectories(path);
        } catch (IOException e) {
            throw new OutputException(path, "create the folder", e);
        }
    }

    /** @return the folder's path */
    public Path getPath() {
        return path;
    }

    /**
     * Opens a file of the folder for writing.
     *
     * @param name its name: letters, digits, dots, dashes, underscores
     * @return the file, to be written and committed
     * @throws OutputException if it cannot be written, or one is there that no run made
     */
    public OutputFile create(String name) {
        claim(name);
        return begin(path.resolve(name));
    }

    /**
     * Writes a whole file.
     *
     * @param name its name: letters, digits, dots, dashes, underscores
     * @param text its contents, written as UTF-8
     * @throws OutputException if it cannot be written, or one is there that no run made
     */
    public void write(String name, String text) {
        write(name, text.getBytes(StandardCharsets.UTF_8));
    }

    /** The same, with the bytes of the file. */
    public void write(String name, byte[] bytes) {
        create(name).writeWhole(bytes);
    }

    /** @return a file for the time of a run, hidden, to be closed without commit */
    public OutputFile createScratch(String name) {
        return begin(path.resolve(name));
    }

    /**
     * Opens the file of a frame, {@code frames/frame-00000.png} for the first.
     *
     * @param index  the number of the frame, from 0
     * @param ending the ending of its name, such as {@code png}
     * @return the file, to be written and committed
     * @throws OutputException if it cannot be written
     */
    public OutputFile createFrame(int index, String ending) {
        if (claim(FRAMES)) {
            createFolder(path.resolve(FRAMES));
        }
        return begin(path.resolve(FRAMES).resolve(String.format(Locale.ROOT, "frame-%05d.%s", index, ending)));
    }

    /**
     * @param wait is run when the program is stopped, before the folder is closed: it may wait until the files are
     *             complete
     */
    public void setWhenStopped(Runnable wait) {
        whenStopped = wait;
    }

    private void stop() {
        whenStopped.run();
        close();
    }

    /** Deletes unfinished files and opens no more; complete ones stay. It closes itself when the program is stopped. */
    @Override
    public void close() {
        try {
            discard();
        } finally {
            unlock();
            hook.close();
        }
    }

    private synchronized void unlock() {
        lock.ifPresent(FolderLock::close);
    }

    /** As {@link #close}, but keeps the folder locked. */
    public void discard() {
        List<OutputFile> parts;
        synchronized (this) {
            closed = true;
            parts = new ArrayList<>(unfinished);
        }
        parts.forEach(OutputFile::close);
    }

    /** The name is listed before the file exists. */
    private synchronized boolean claim(String name) {
        if (made.contains(name)) {
            return false;
        }
        made.claim(name);
        made.write();
        return true;
    }

    private synchronized OutputFile begin(Path file) {
        if (closed) {
            throw new OutputException(file, "write", "the run is being stopped", null);
        }
        OutputFile begun = new OutputFile(file, disk, this::done);
        unfinished.add(begun);
        return begun;
    }

    private synchronized void done(OutputFile file) {
        unfinished.remove(file);
    }

    /**
     * The lock that keeps a second run out of a folder while a run writes there. It is a small hidden file that the
     * operating system unlocks when the process ends, however it ends, so that a killed run does not lock its folder.
     */
    private record FolderLock(Path file, FileChannel channel) implements AutoCloseable {
        /** The file's name; it holds the number of the process that writes. */
        static final String NAME = ".desolver-writing";

        /**
         * @param folder an existing folder
         * @return its lock
         * @throws OutputException if another run holds it, or the folder cannot be written
         */
        static FolderLock of(Path folder, Disk disk) {
            Path file = folder.resolve(NAME);
            try {
                FileChannel channel = FileChannel.open(file, StandardOpenOption.CREATE, StandardOpenOption.READ,
                        StandardOpenOption.WRITE, LinkOption.NOFOLLOW_LINKS);
                try {
                    if (!disk.lock(channel)) {
                        String owner = Files.readString(file, StandardCharsets.US_ASCII);
                        throw new OutputException(folder, "write into", "another run"
                                + (owner.matches("\\d{1,19}") ? ", process " + owner + "," : "")
                                + " is writing there; wait until it ends, or choose another folder", null);
                    }
                    channel.truncate(0);
                    channel.write(ByteBuffer.wrap(Long.toString(ProcessHandle.current().pid())
                            .getBytes(StandardCharsets.US_ASCII)));
                    return new FolderLock(file, channel);
                } catch (IOException | OutputException e) {
                    channel.close();
                    throw e;
                }
            } catch (IOException e) {
                throw new OutputException(file, "write", e);
            }
        }

        /** Unlocks the folder. */
        @Override
        public void close() {
            try (channel) {
                if (channel.isOpen()) {
                    Files.deleteIfExists(file);
                }
            } catch (IOException e) {
                throw new OutputException(file, "remove", e);
            }
        }
    }
}
