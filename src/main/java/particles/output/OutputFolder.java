package particles.output;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;

/**
 * The folder of a run's results. It remembers in a small hidden file which names it wrote, so that a new run removes
 * what the old one made and nothing else; a file of the same name that no run made is never overwritten. Every file is
 * written whole or not at all. Nothing outside the folder is touched.
 */
public final class OutputFolder implements AutoCloseable {
    /** The folder of the frames, in the output folder. */
    public static final String FRAMES = "frames";

    private final Path path;
    private final OutputFile.Opener opener;
    private final MadeList made;
    private final Set<OutputFile> unfinished = new LinkedHashSet<>();
    private final boolean reopened;
    private boolean closed;

    private OutputFolder(Path path, OutputFile.Opener opener, boolean reopened) {
        this.reopened = reopened;
        this.path = path;
        this.opener = opener;
        this.made = new MadeList(path, opener);
    }

    /**
     * Creates the folder, or removes from it what a previous run made.
     *
     * @param path  where
     * @param names the files that are going to be written, to learn before a long run that they cannot be; {@link #FRAMES}
     *              for frames. Others may follow.
     * @return the folder, ready to be written to
     * @throws OutputException if it cannot be created or written, or holds a file of these names that no run made
     */
    public static OutputFolder open(Path path, String... names) {
        return open(path, OutputFile.ON_DISK, names);
    }

    static OutputFolder open(Path path, OutputFile.Opener opener, String... names) {
        createFolder(path);
        OutputFolder folder = new OutputFolder(path, opener, false);
        folder.made.removeOldRun();
        folder.claimAll(names);
        return folder;
    }

    /**
     * Opens the folder of a run that is to be continued; nothing is removed from it.
     *
     * @param path  where
     * @param names the files that are going to be written
     * @return the folder, ready to be written to
     * @throws OutputException if it cannot be written, or holds a file of these names that no run made
     */
    public static OutputFolder reopen(Path path, String... names) {
        OutputFolder folder = new OutputFolder(path, OutputFile.ON_DISK, true);
        folder.made.readOldRun();
        folder.claimAll(names);
        return folder;
    }

    private void claimAll(String... names) {
        for (String name : names) {
            made.claim(name);
        }
        made.write();
        if (made.contains(FRAMES)) {
            createFolder(path.resolve(FRAMES));
        }
    }

    private static void createFolder(Path path) {
        try {
            Files.createDirectories(path);
        } catch (IOException e) {
            throw new OutputException(path, "create the folder", e);
        }
    }

    /** @return whether it holds a run that is to be continued */
    public boolean isReopened() {
        return reopened;
    }

    /** @return where the folder is */
    public Path getPath() {
        return path;
    }

    /**
     * Begins a file of the folder.
     *
     * @param name its name: letters, digits, dots, dashes, underscores
     * @return the file, to be written and committed
     * @throws OutputException if it cannot be written, or one is there that no run made
     */
    public OutputFile create(String name) {
        claim(name);
        return begin(path.resolve(name), 0);
    }

    /**
     * Goes on with a file that an earlier run began: whether that run was stopped and completed the file, or was killed and
     * did not.
     *
     * @param name   its name
     * @param length how many of its bytes stand; what follows them is taken back
     * @return the file, to be written on and committed
     * @throws OutputException if it cannot be written, or is not as long as that
     */
    public OutputFile goOn(String name, long length) {
        claim(name);
        Path file = path.resolve(name);
        Path part = OutputFile.partOf(file);
        try {
            if (size(part) < length) {
                if (size(file) < length) {
                    throw new OutputException(file, "continue", "it is not as long any more as when the run was interrupted",
                            null);
                }
                Files.copy(file, part, StandardCopyOption.REPLACE_EXISTING);
            }
        } catch (IOException e) {
            throw new OutputException(file, "continue", e);
        }
        return begin(file, length);
    }

    private static long size(Path file) throws IOException {
        return Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS) ? Files.size(file) : -1;
    }

    /**
     * Removes a file of this run.
     *
     * @param name its name
     * @throws OutputException if it cannot be removed
     */
    public void remove(String name) {
        try {
            Files.deleteIfExists(path.resolve(name));
        } catch (IOException e) {
            throw new OutputException(path.resolve(name), "remove", e);
        }
    }

    /**
     * Begins the file of a frame, {@code frames/frame-00000.png} for the first.
     *
     * @param index the number of the frame, from 0
     * @return the file, to be written and committed
     * @throws OutputException if it cannot be written
     */
    public OutputFile createFrame(int index) {
        if (claim(FRAMES)) {
            createFolder(path.resolve(FRAMES));
        }
        return begin(frameFile(index), 0);
    }

    /** Where a frame is. */
    Path frameFile(int index) {
        return path.resolve(FRAMES).resolve(String.format(Locale.ROOT, "frame-%05d.png", index));
    }

    /**
     * Throws away what is unfinished and begins nothing any more; what is complete stays. For the end of a program,
     * also from another thread when it is being stopped.
     */
    @Override
    public void close() {
        List<OutputFile> parts;
        synchronized (this) {
            closed = true;
            parts = new ArrayList<>(unfinished);
        }
        parts.forEach(OutputFile::close);
    }

    /** The name is in the list before the file is in the folder. */
    private synchronized boolean claim(String name) {
        if (made.contains(name)) {
            return false;
        }
        made.claim(name);
        made.write();
        return true;
    }

    private synchronized OutputFile begin(Path file, long length) {
        if (closed) {
            throw new OutputException(file, "write", "the run is being stopped", null);
        }
        OutputFile[] self = new OutputFile[1];
        self[0] = new OutputFile(file, opener, length, () -> done(self[0]));
        unfinished.add(self[0]);
        return self[0];
    }

    private synchronized void done(OutputFile file) {
        unfinished.remove(file);
    }
}
