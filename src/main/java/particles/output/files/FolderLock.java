package particles.output.files;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

/**
 * The lock that keeps a second run out of a folder while a run writes there. It is a small hidden file that the
 * operating system unlocks when the process ends, however it ends, so that a killed run does not lock its folder.
 */
record FolderLock(Path file, FileChannel channel) implements AutoCloseable {
    /** The file's name; it holds the number of the process that writes. */
    static final String NAME = ".desolver-writing";

    /**
     * @param folder an existing folder
     * @return its lock
     * @throws OutputException if another run holds it, or the folder cannot be written
     */
    static FolderLock of(Path folder) {
        Path file = folder.resolve(NAME);
        try {
            FileChannel channel = FileChannel.open(file, StandardOpenOption.CREATE, StandardOpenOption.READ,
                    StandardOpenOption.WRITE, LinkOption.NOFOLLOW_LINKS);
            try {
                if (!isFree(channel)) {
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

    private static boolean isFree(FileChannel channel) throws IOException {
        try {
            return channel.tryLock() != null;
        } catch (OverlappingFileLockException e) {
            return false;                               // this process holds it, for another run
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
