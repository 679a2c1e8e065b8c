package particles;

import static org.junit.jupiter.api.Assumptions.abort;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** What only some systems have: tests that need it are skipped on others. */
public final class OtherSystems {
    private OtherSystems() {
    }

    /** Makes a symbolic link; on Windows only some users may. */
    public static void link(Path link, Path target) {
        try {
            Files.createSymbolicLink(link, target);
        } catch (IOException | UnsupportedOperationException e) {
            abort("links are not allowed here: " + e);
        }
    }

    public static void assumeBash() {
        assumeTrue(Files.isExecutable(Path.of("/bin/bash")), "needs bash");
    }

    /** Windows only knows the end of a process that may not tidy up. */
    public static void assumeSignals() {
        assumeTrue(ProcessHandle.current().supportsNormalTermination(), "needs signals");
    }
}
