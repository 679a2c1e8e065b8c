package particles.app.run;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import particles.app.cli.ExitCode;

class StopRequestTest {
    private final StopRequest stop = new StopRequest();
    private final List<Integer> exits = new ArrayList<>();

    @Test
    void aProgramThatIsNotStoppedEndsWithItsOwnCode() {
        stop.end(ExitCode.BAD_INPUT, exits::add);
        assertEquals(List.of(2), exits);
    }

    /** Without this, once in thousands of stops the exit code was 3 instead of SIGTERM's 143. */
    @Test
    void aSignalKeepsItsCode() {
        stop.request();
        stop.end(ExitCode.STOPPED, exits::add);
        assertEquals(List.of(), exits);
    }
}
