package particles.output.files;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.channels.FileChannel;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;

/**
 * What writing results asks of the operating system. Systems differ: on Windows nobody can rename or delete a file that
 * another program has open, or read the part of one that another program has locked. Tests play such a system, or a
 * full disk.
 */
@FunctionalInterface
public interface Disk {
    /** The disk of this machine. */
    Disk REAL = file -> {
        Files.deleteIfExists(file);                     // writing to it could follow a link
        return Files.newOutputStream(file, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
    };

    /** Opens a new file for writing, in the place of an existing one. */
    OutputStream create(Path file) throws IOException;

    /** Renames a file, in the place of an existing one, in one step. */
    default void rename(Path from, Path to) throws IOException {
        Files.move(from, to, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
    }

    /**
     * Locks a file against other programs, until the channel is closed or the program ends, however it ends. The lock
     * is on a byte far behind the file's end, so that everybody can read the file.
     *
     * @return whether nobody else has locked it
     */
    default boolean lock(FileChannel file) throws IOException {
        try {
            return file.tryLock(Long.MAX_VALUE - 1, 1, false) != null;
        } catch (OverlappingFileLockException e) {
            return false;                               // this program has, for another run
        }
    }
}
