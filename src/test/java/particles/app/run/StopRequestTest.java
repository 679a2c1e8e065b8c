package particles.app.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.PrintWriter;
import java.io.StringWriter;
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

    /** Without this, some stops of a command that ends when its files are taken from it said nothing. */
    @Test
    void aCommandThatFailsAtOnceIsReportedAsStopped() throws InterruptedException {
        for (int i = 0; i < 2000; i++) {
            StopRequest stop = new StopRequest();
            Thread command = new Thread(() -> {
                while (!stop.isWanted()) {
                    Thread.onSpinWait();
                }
                stop.end(ExitCode.STOPPED, exits::add);
            });
            command.start();
            StringWriter lines = new StringWriter();
            assertTrue(stop.stop(new PrintWriter(lines)));
            command.join();
            assertEquals("stopped", lines.toString().strip());
        }
    }

    /** A command that cannot write any more may end before the thread that prints the line has begun. */
    @Test
    void aCommandThatFailsAsTheProcessEndsIsReportedAsStopped() {
        StopRequest stop = new StopRequest(() -> true);
        StringWriter lines = new StringWriter();
        stop.end(ExitCode.STOPPED, exits::add);
        assertTrue(stop.stop(new PrintWriter(lines)));
        assertEquals("stopped", lines.toString().strip());
        assertEquals(List.of(), exits);
    }

    @Test
    void aCommandThatCameToItsEndIsNotReportedAsStopped() {
        StringWriter lines = new StringWriter();
        stop.end(ExitCode.DONE, exits::add);
        assertFalse(stop.stop(new PrintWriter(lines)));
        assertEquals("", lines.toString());
    }
}
