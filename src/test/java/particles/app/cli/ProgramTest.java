package particles.app.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.arguments;
import static particles.Texts.assertHas;

import deSolvers.DESolverException;
import deSolvers.EulerSolver;
import deSolvers.catalog.SolverCatalog;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.UncheckedIOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import particles.SimulationException;
import particles.app.Main;
import particles.app.run.StopRequest;
import particles.output.files.OutputException;
import particles.spec.messages.InvalidInputException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** The command line: messages, exit codes, and no stack trace for expected failures. */
class ProgramTest {
    /** A command with an option of each kind that prints them, or fails on request. */
    @Command(name = "try", description = "Tries the options.")
    private static final class TryCommand extends ProgramCommand {
        @Option(names = "--deltaT", paramLabel = "SECONDS", description = "The time step.")
        private Double deltaT;
        @Option(names = "--frames", arity = "0..1", fallbackValue = "true", paramLabel = "true|false",
                description = "Pictures or not.")
        private boolean frames;
        @Option(names = "--scene", paramLabel = "NAME", description = "The scene, as in gradle --help.")
        private String scene;

        private Throwable failure;

        @Override
        public void run(PrintWriter out) throws Exception {
            if (failure instanceof Error error) {
                throw error;
            }
            if (failure instanceof Exception exception) {
                throw exception;
            }
            out.println("deltaT=" + deltaT + " frames=" + frames + " scene=" + scene);
        }
    }

    private final TryCommand command = new TryCommand();

    private final List<ProgramCommand> commands = Stream.concat(Main.commands(new StopRequest()).stream(),
            Stream.of(command)).toList();

    private Screen execute(OptionStyle style, String... args) {
        return Screen.of(commands, style, args);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            --deltaT=1e-3 --frames              | deltaT=0.001 frames=true scene=null
            --scene=a=b --frames=true           | deltaT=null frames=true scene=a=b
            --scene=@/etc/passwd --frames=false | deltaT=null frames=false scene=@/etc/passwd
            """)
    void optionsReachTheCommandLiterally(String typed, String printed) {
        assertEquals(new Screen(ExitCode.DONE, printed, ""), execute(OptionStyle.SHELL, ("try " + typed).split(" ")));
    }

    /** What is typed, and the line that refuses it. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
            GRADLE | try --deltat=0.1         | unknown option -Pdeltat; did you mean -PdeltaT? allowed: -PdeltaT, \
            -Pframes, -Pscene, -Phelp
            GRADLE | try --dt=0.1             | unknown option -Pdt; did you mean -PdeltaT? allowed: -PdeltaT, \
            -Pframes, -Pscene, -Phelp
            SHELL  | try --scenes=2           | unknown option --scenes; did you mean --scene? allowed: --deltaT, \
            --frames, --scene, --help
            SHELL  | try -Pscene=2            | unknown option -Pscene; did you mean --scene? allowed: --deltaT, \
            --frames, --scene, --help
            SHELL  | solvers --colour=red     | unknown option --colour; allowed: --help
            GRADLE | try --deltaT=soon --scne=2 --zoom | option -PdeltaT: 'soon' is not a double \
            // unknown option -Pscne; did you mean -Pscene? allowed: -PdeltaT, -Pframes, -Pscene, -Phelp \
            // unknown option -Pzoom; allowed: -PdeltaT, -Pframes, -Pscene, -Phelp
            GRADLE | try --deltaT             | option -PdeltaT needs a value: -PdeltaT=SECONDS
            SHELL  | try --scene=1 --scene=2  | option --scene was given twice
            SHELL  | solvers @/etc/passwd     | unexpected '@/etc/passwd'; options are written --name=value; \
            allowed: --help
            SHELL  | solver                   | unknown command 'solver'; did you mean 'solvers'? commands: COMMANDS
            SHELL  | ``                       | a command is missing; commands: COMMANDS
            SHELL  | --scene=2                | option --scene=2 has to follow a command; commands: COMMANDS
            """)
    void wrongCommandsAndOptionsAreRefused(OptionStyle style, String typed, String lines) {
        assertEquals(new Screen(ExitCode.BAD_INPUT, "", lines.replace(" // ", System.lineSeparator())
                .replace("COMMANDS", commands.stream().map(ProgramCommand::name).collect(Collectors.joining(", ")))),
                execute(style, typed.isEmpty() ? new String[0] : typed.split(" ")));
    }

    /** After such an error the parser sets no default values, so that nothing else can be said of the options. */
    @ParameterizedTest
    @CsvSource({"run, frames", "workPrecision, svg", "report, svg", "stiffGallery, slide", "effectCost, slide"})
    void aFlagIsTrueOrFalse(String name, String flag) {
        assertEquals(new Screen(ExitCode.BAD_INPUT, "", "option --" + flag + " has to be true or false, not 'maybe'"),
                execute(OptionStyle.SHELL, name, "--" + flag + "=maybe"));
    }

    @Test
    void allWrongOptionsOfAnExperimentAreReported() {
        Screen screen = execute(OptionStyle.GRADLE, "energyDrift", "--scene=no-such-scene", "--set=deltaT",
                "--solvers=rk5");
        assertEquals(ExitCode.BAD_INPUT, screen.code());
        assertEquals(3, screen.err().lines().count(), screen.err());
    }

    @Test
    void helpShowsTheOptionsAsTheyAreTyped() {
        Screen screen = execute(OptionStyle.GRADLE, "try", "--help");
        assertEquals(ExitCode.DONE, screen.code());
        assertHas(screen.out(), "-PdeltaT=SECONDS", "-Pscene=NAME", "Tries the options.");
    }

    @Test
    void helpOfTheProgramListsTheCommands() {
        assertHas(execute(OptionStyle.SHELL, "--help").out(), "solvers", "Tries the options.");
    }

    /** The memory estimate may be too small: running out of memory is also one line that says what to do. */
    static Stream<Arguments> failures() {
        long most = Runtime.getRuntime().maxMemory();
        IOException full = new IOException("No space left on device");
        return Stream.of(
                arguments(ExitCode.STOPPED, "the kinetic energy is too large",
                        new SimulationException(1, 0, "the kinetic energy is too large", null)),
                arguments(ExitCode.STOPPED, "SimulationException", new SimulationException(1, 0, null, null)),
                arguments(ExitCode.STOPPED, "EulerSolver at t = 1.0, deltaT = 0.5: not finite",
                        new DESolverException(EulerSolver.class, 1, 0.5, -1, "not finite", "")),
                arguments(ExitCode.TROUBLE, "build/out/a.csv: No space left on device", new UncheckedIOException(
                        new FileSystemException("build/out/a.csv", null, "No space left on device"))),
                arguments(ExitCode.TROUBLE, "cannot write build/out/run.json: the disk is full",
                        new OutputException(Path.of("build/out/run.json"), "write", full)),
                arguments(ExitCode.TROUBLE, "cannot write frame-00000.png: No space left on device",
                        new IOException("cannot write frame-00000.png", full)),
                arguments(ExitCode.TROUBLE, "build/out: permission denied", new AccessDeniedException("build/out")),
                arguments(ExitCode.TROUBLE, "a.yaml: no such file or folder", new NoSuchFileException("a.yaml")),
                arguments(ExitCode.BAD_INPUT, "one" + System.lineSeparator() + "two",
                        new InvalidInputException(List.of("one", "two"))),
                arguments(ExitCode.TROUBLE, "out of memory: Java may use " + (most >> 20)
                        + " MiB; use fewer particles, frames or runs, or give Java more: JAVA_TOOL_OPTIONS=-Xmx"
                        + ((most >> 30) + 1) + "g", new OutOfMemoryError("Java heap space")));
    }

    @ParameterizedTest
    @MethodSource("failures")
    void anExpectedFailureIsItsLinesAndItsCode(ExitCode code, String line, Throwable failure) {
        command.failure = failure;
        assertEquals(new Screen(code, "", line), execute(OptionStyle.SHELL, "try"));
    }

    static List<Throwable> unexpected() {
        return List.of(new IllegalStateException("impossible"), new StackOverflowError("too deep"));
    }

    @ParameterizedTest
    @MethodSource("unexpected")
    void anUnexpectedExceptionIsNotSwallowed(Throwable failure) {
        command.failure = failure;
        Screen screen = execute(OptionStyle.SHELL, "try");
        assertEquals(ExitCode.TROUBLE, screen.code());
        assertHas(screen.err(), failure.toString(), "at particles.app.cli.ProgramTest.");
    }

    @Test
    void everySolverHasItsLine() {
        String out = execute(OptionStyle.SHELL, "solvers").out();
        assertEquals(SolverCatalog.names(), out.lines().map(line -> line.split(" ")[0]).toList());
        assertTrue(out.lines().anyMatch(line -> line.matches("rk4 +order 4  The old workhorse.*")), out);
    }
}
