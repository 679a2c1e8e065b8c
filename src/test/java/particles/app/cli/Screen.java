package particles.app.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.List;

/** Runs commands as the program does. */
public final class Screen {
    private Screen() {
    }

    /** @return what a command prints, which has to end with this exit code */
    public static String of(ExitCode expected, List<ProgramCommand> commands, OptionStyle style, String... args) {
        StringWriter out = new StringWriter();
        PrintWriter both = new PrintWriter(out);
        assertEquals(expected, new Program(commands, style, both, both).execute(args), out.toString());
        return out.toString();
    }
}
