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
    void aProgramThatNobodyStopsEndsWithItsOwnCode() {
        stop.end(ExitCode.BAD_INPUT, exits::add);
        assertEquals(List.of(2), exits);
    }

    /** Once in thousands of stops Java took the program's 3 instead of 143 of SIGTERM. */
    @Test
    void aSignalKeepsItsCode() {
        stop.request();
        stop.end(ExitCode.STOPPED, exits::add);
        assertEquals(List.of(), exits);
    }
}
