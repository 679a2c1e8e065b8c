package particles.output.files;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.DirectoryNotEmptyException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.NotDirectoryException;
import java.nio.file.Path;
import java.util.Locale;

/**
 * Thrown when a result cannot be written. The message is one line: the file, the attempted action and the reason.
 */
public class OutputException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    private final transient Path file;

    /**
     * @param file  the file or folder
     * @param what  the attempted action, such as {@code write}
     * @param why   the reason
     * @param cause the cause, or null if there is none
     */
    public OutputException(Path file, String what, String why, Throwable cause) {
        super("cannot " + what + " " + file + ": " + why, cause);
        this.file = file;
    }

    /**
     * @param file  the file or folder
     * @param what  the attempted action
     * @param cause the exception of the file system
     */
    public OutputException(Path file, String what, IOException cause) {
        this(file, what, reason(file, cause), cause);
    }

    /** @return the file or folder */
    public Path getFile() {
        return file;
    }

    /** The message of a file system's exception is often only the file's name, so its class is used too. */
    private static String reason(Path file, IOException e) {
        if (e instanceof AccessDeniedException) {
            return "permission denied";
        }
        if (e instanceof NoSuchFileException) {
            Path folder = file.toAbsolutePath().getParent();
            return folder != null && Files.isDirectory(folder) ? "the system does not allow it"
                    : "its folder does not exist";
        }
        if (e instanceof NotDirectoryException || e instanceof FileAlreadyExistsException) {
            return "a file is where a folder should be";
        }
        if (e instanceof DirectoryNotEmptyException) {
            return "a folder is where the file should be";
        }
        String message = e instanceof FileSystemException f && f.getReason() != null ? f.getReason() : e.getMessage();
        if (message == null || message.isBlank()) {
            return e.getClass().getSimpleName();
        }
        String line = message.lines().findFirst().orElse(message).strip();
        if (line.toLowerCase(Locale.ROOT).contains("no space left")) {
            return "the disk is full";
        }
        return line.equals("Not a directory") ? "a file is where a folder should be" : line;
    }
}
