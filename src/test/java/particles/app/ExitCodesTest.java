package particles.app;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Exit codes of the program in a child process; {@link FaultsTest} has those of faults, {@link BadInputTest} those of
 * wrong input.
 */
class ExitCodesTest {
    @TempDir
    Path top;

    @ParameterizedTest
    @CsvSource(textBlock = """
            0, --duration=0.1
            3, --deltaT=10 --duration=1000
            """)
    void exitCodesReachTheSystem(int code, String options) throws IOException, InterruptedException {
        String typed = "run --scene=2 --frames=false --out=" + top.resolve("out") + " " + options;
        ChildProgram.End end = new ChildProgram(top.resolve("lines.txt")).run(typed.split(" "));
        assertEquals(code, end.code(), end.lines());
    }
}
