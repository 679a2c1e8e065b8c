package particles.app;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Exit codes of the program in a child process; {@link StartUpTest} has that of success, {@link FaultsTest} those of
 * faults, {@link BadInputTest} those of wrong input.
 */
class ExitCodesTest {
    @TempDir
    Path top;

    @Test
    void theCodeOfABlowUpReachesTheSystem() throws IOException, InterruptedException {
        ChildProgram.End end = new ChildProgram(top.resolve("lines.txt")).run("run", "--scene=2", "--frames=false",
                "--out=" + top.resolve("out"), "--deltaT=10", "--duration=1000");
        assertEquals(3, end.code(), end.lines());
    }
}
