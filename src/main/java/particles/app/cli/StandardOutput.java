package particles.app.cli;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Standard output. If it goes to a program that reads no further, as {@code head} does, the rest is dropped. */
public final class StandardOutput extends FileOutputStream {
    private static final Path DEVICE = Path.of("/dev/stdout");
    private static final int FILE_TYPE = 0xf000;
    private static final int PIPE = 0x1000;

    /** The process's own standard output. */
    public StandardOutput() {
        super(FileDescriptor.out);
    }

    @Override
    public void write(byte[] bytes, int offset, int length) throws IOException {
        try {
            super.write(bytes, offset, length);
        } catch (IOException e) {
            if (!isPipe()) {
                throw e;                                // a full disk, for example
            }
        }
    }

    /** Asks for the kind of file, since the message of an exception depends on the user's language. */
    private static boolean isPipe() throws IOException {
        return Files.exists(DEVICE) && ((int) Files.getAttribute(DEVICE, "unix:mode") & FILE_TYPE) == PIPE;
    }
}
