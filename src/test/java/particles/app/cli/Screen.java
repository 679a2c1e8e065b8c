package particles.app.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.List;

/**
 * Runs commands as the program does.
 *
 * @param code the exit code
 * @param out  what was printed, without the last line end
 * @param err  the same of errors
 */
public record Screen(ExitCode code, String out, String err) {
    public static Screen of(List<ProgramCommand> commands, OptionStyle style, String... args) {
        StringWriter out = new StringWriter();
        StringWriter err = new StringWriter();
        ExitCode code = new Program(commands, style, new PrintWriter(out), new PrintWriter(err)).execute(args);
        return new Screen(code, out.toString().stripTrailing(), err.toString().stripTrailing());
    }

    /** @return what a command prints, errors too; it has to end with this exit code */
    public static String of(ExitCode expected, List<ProgramCommand> commands, OptionStyle style, String... args) {
        StringWriter out = new StringWriter();
        PrintWriter both = new PrintWriter(out);
        assertEquals(expected, new Program(commands, style, both, both).execute(args), out.toString());
        return out.toString();
    }
}
