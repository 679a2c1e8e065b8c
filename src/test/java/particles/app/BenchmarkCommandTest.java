package particles.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import particles.app.cli.ExitCode;
import particles.app.cli.OptionStyle;
import particles.app.cli.Program;

/** Invalid options of the benchmark are refused in one line. */
class BenchmarkCommandTest {

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            --fork=2           | unknown option -Pfork; did you mean -Pforks? allowed: -Pout, -Pslide, -Psvg, -Pdark, \
            -Pinclude, -Pforks, -Piterations, -Pseconds, -Phelp
            --forks=0          | option -Pforks: 0 has to be 1 or more
            --iterations=-1    | option -Piterations: -1 has to be 1 or more
            --seconds=0        | option -Pseconds: 0.0 has to be finite and more than 0
            --include=chain[   | option -Pinclude: 'chain[' is no regular expression: Unclosed character class
            --include=runge    | option -Pinclude: 'runge' is found in none of: comparison oscillator euler Euler \
            equal evaluations,
            """)
    void invalidOptionsAreRefused(String option, String line) {
        StringWriter lines = new StringWriter();
        PrintWriter both = new PrintWriter(lines);
        Program program = new Program(List.of(new BenchmarkCommand()), OptionStyle.GRADLE, both, both);
        assertEquals(ExitCode.BAD_INPUT, program.execute(BenchmarkCommand.NAME, option));
        assertTrue(lines.toString().startsWith(line) && lines.toString().lines().count() == 1, lines.toString());
    }
}
