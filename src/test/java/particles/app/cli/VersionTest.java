package particles.app.cli;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

class VersionTest {
    @Test
    void theBuildHasTheSameVersion() throws IOException {
        String wanted = "version = '" + Version.CURRENT + "'";
        assertTrue(Files.readAllLines(Path.of("build.gradle")).stream().anyMatch(line -> line.startsWith(wanted)),
                wanted);
    }
}
