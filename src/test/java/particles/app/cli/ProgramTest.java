package particles.app.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.DESolverException;
import deSolvers.EulerSolver;
import deSolvers.catalog.SolverCatalog;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import particles.SimulationException;
import particles.app.Main;
import particles.app.run.StopRequest;
import particles.output.files.OutputException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** The command line: messages, exit codes, and no stack trace for expected failures. */
class ProgramTest {
    private final StringWriter out = new StringWriter();
    private final StringWriter err = new StringWriter();

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

    /** As with output redirected to a full disk. */
    @Test
    void outputThatCannotBePrintedIsAnError() {
        PrintWriter full = new PrintWriter(new Writer() {
            @Override
            public void write(char[] letters, int offset, int length) throws IOException {
                throw new IOException("No space left on device");
            }

            @Override
            public void flush() {
            }

            @Override
            public void close() {
            }
        });
        assertEquals(ExitCode.TROUBLE, new Program(List.of(command), OptionStyle.SHELL, full,
                new PrintWriter(err)).execute("try", "--scene=a"));
        assertEquals("some output could not be printed: the destination is full or closed",
                err.toString().strip());
    }

    private ExitCode execute(OptionStyle style, String... args) {
        List<ProgramCommand> commands = new ArrayList<>(Main.commands(new StopRequest()));
        commands.add(command);
        return new Program(commands, style, new PrintWriter(out), new PrintWriter(err)).execute(args);
    }

    private void assertRefused(OptionStyle style, String line, String... args) {
        assertEquals(ExitCode.BAD_INPUT, execute(style, args));
        assertEquals(line, err.toString().strip());
        assertEquals("", out.toString());
    }

    @Test
    void optionsReachTheCommand() {
        assertEquals(ExitCode.DONE, execute(OptionStyle.SHELL, "try", "--deltaT=1e-3", "--frames", "--scene=a=b c"));
        assertEquals("deltaT=0.001 frames=true scene=a=b c", out.toString().strip());
        assertEquals("", err.toString());
    }

    @Test
    void valuesAreTakenLiterally() {
        assertEquals(ExitCode.DONE, execute(OptionStyle.SHELL, "try", "--scene=@/etc/passwd", "--frames=false"));
        assertEquals("deltaT=null frames=false scene=@/etc/passwd", out.toString().strip());
    }

    @Test
    void unknownOptionIsRefusedWithASuggestion() {
        assertRefused(OptionStyle.GRADLE,
                "unknown option -Pdeltat; did you mean -PdeltaT? allowed: -PdeltaT, -Pframes, -Pscene, -Phelp",
                "try", "--deltat=0.1");
    }

    @Test
    void theCommonNameOfAnOptionIsUnderstood() {
        assertRefused(OptionStyle.GRADLE,
                "unknown option -Pdt; did you mean -PdeltaT? allowed: -PdeltaT, -Pframes, -Pscene, -Phelp",
                "try", "--dt=0.1");
    }

    @Test
    void unknownOptionIsWrittenAsItWasTyped() {
        assertRefused(OptionStyle.SHELL,
                "unknown option --scenes; did you mean --scene? allowed: --deltaT, --frames, --scene, --help",
                "try", "--scenes=2");
    }

    @Test
    void gradlesOptionsAreRecognisedInTheShell() {
        assertRefused(OptionStyle.SHELL,
                "unknown option -Pscene; did you mean --scene? allowed: --deltaT, --frames, --scene, --help",
                "try", "-Pscene=2");
    }

    @Test
    void unknownOptionWithoutSuggestionListsTheAllowedOnes() {
        assertRefused(OptionStyle.SHELL, "unknown option --colour; allowed: --help", "solvers", "--colour=red");
    }

    @Test
    void allErrorsAreReportedTogether() {
        assertRefused(OptionStyle.GRADLE, String.join(System.lineSeparator(),
                "option -PdeltaT: 'soon' is not a double",
                "unknown option -Pscne; did you mean -Pscene? allowed: -PdeltaT, -Pframes, -Pscene, -Phelp",
                "unknown option -Pzoom; allowed: -PdeltaT, -Pframes, -Pscene, -Phelp"),
                "try", "--deltaT=soon", "--scne=2", "--zoom");
    }

    @Test
    void namesAndValuesOfOptionsAreReportedTogether() {
        assertEquals(ExitCode.BAD_INPUT, execute(OptionStyle.SHELL, "run", "--scnee=2", "--scene=no-such-scene",
                "--deltaT=abc", "--solver=rk5", "--threads=-1", "--video=avi", "--out="));
        List<String> lines = err.toString().lines().toList();
        List<String> beginnings = List.of("unknown option --scnee; did you mean --scene?", "option --video: 'avi'",
                "there is no scene 'no-such-scene'", "--solver: unknown solver 'rk5'", "--deltaT: ", "--threads: ",
                "option --out: needs a folder name");
        for (String beginning : beginnings) {
            assertEquals(1, lines.stream().filter(line -> line.startsWith(beginning)).count(), beginning + " in "
                    + lines);
        }
        assertEquals(beginnings.size(), lines.size(), lines.toString());
    }

    @Test
    void allWrongOptionsOfAnExperimentAreReported() {
        assertEquals(ExitCode.BAD_INPUT, execute(OptionStyle.GRADLE, "energyDrift", "--scene=no-such-scene",
                "--deltaT=-1", "--duration=soon", "--solvers=rk5"));
        assertEquals(4, err.toString().lines().count(), err.toString());
    }

    @Test
    void optionWithoutItsValueIsRefused() {
        assertRefused(OptionStyle.GRADLE, "option -PdeltaT needs a value: -PdeltaT=SECONDS", "try", "--deltaT");
    }

    @Test
    void optionGivenTwiceIsRefused() {
        assertRefused(OptionStyle.SHELL, "option --scene was given twice", "try", "--scene=1", "--scene=2");
    }

    @Test
    void argumentThatIsNoOptionIsRefused() {
        assertRefused(OptionStyle.SHELL, "unexpected 'cloth'; options are written --name=value; allowed: --help",
                "solvers", "cloth");
    }

    @Test
    void unknownCommandIsRefused() {
        assertRefused(OptionStyle.SHELL, "unknown command 'solver'; did you mean 'solvers'? commands: " + commands(),
                "solver");
    }

    @Test
    void missingCommandIsRefused() {
        assertRefused(OptionStyle.SHELL, "a command is missing; commands: " + commands());
    }

    @Test
    void optionBeforeTheCommandIsRefused() {
        assertRefused(OptionStyle.SHELL, "option --scene=2 has to follow a command; commands: " + commands(),
                "--scene=2");
    }

    private static String commands() {
        List<String> names = new ArrayList<>();
        Main.commands(new StopRequest())
                .forEach(known -> names.add(known.getClass().getAnnotation(Command.class).name()));
        names.add("try");
        return String.join(", ", names);
    }

    @Test
    void helpShowsTheOptionsAsTheyAreTyped() {
        assertEquals(ExitCode.DONE, execute(OptionStyle.GRADLE, "try", "--help"));
        assertTrue(out.toString().contains("-PdeltaT=SECONDS"), out.toString());
        assertTrue(out.toString().contains("-Pscene=NAME"), out.toString());
        assertTrue(out.toString().contains("Tries the options."), out.toString());
    }

    @Test
    void helpOfTheProgramListsTheCommands() {
        assertEquals(ExitCode.DONE, execute(OptionStyle.SHELL, "--help"));
        assertTrue(out.toString().contains("solvers") && out.toString().contains("Tries the options."), out.toString());
    }

    private void assertEnds(ExitCode code, String line, Throwable failure) {
        command.failure = failure;
        assertEquals(code, execute(OptionStyle.SHELL, "try"));
        assertEquals(line, err.toString().strip());
    }

    @Test
    void blowUpIsOneLineAndCode3() {
        assertEnds(ExitCode.STOPPED, "the kinetic energy is too large",
                new SimulationException(1, 0, "the kinetic energy is too large", null));
    }

    @Test
    void solverThatGivesUpIsOneLineAndCode3() {
        assertEnds(ExitCode.STOPPED, "EulerSolver at t = 1.0, deltaT = 0.5: not finite",
                new DESolverException(EulerSolver.class, 1, 0.5, -1, "not finite", ""));
    }

    @Test
    void fullDiskIsOneLineAndCode1() {
        assertEnds(ExitCode.TROUBLE, "build/out/a.csv: No space left on device",
                new UncheckedIOException(new FileSystemException("build/out/a.csv", null, "No space left on device")));
    }

    @Test
    void resultThatCannotBeWrittenIsOneLineAndCode1() {
        assertEnds(ExitCode.TROUBLE, "cannot write build/out/run.json: the disk is full",
                new OutputException(Path.of("build/out/run.json"), "write",
                new IOException("No space left on device")));
    }

    @Test
    void causeOfAnIOExceptionIsNamed() {
        assertEnds(ExitCode.TROUBLE, "cannot write frame-00000.png: No space left on device",
                new IOException("cannot write frame-00000.png", new IOException("No space left on device")));
    }

    @Test
    void unwritableFolderIsOneLineAndCode1() {
        assertEnds(ExitCode.TROUBLE, "build/out: permission denied", new AccessDeniedException("build/out"));
    }

    @Test
    void missingFileIsOneLineAndCode1() {
        assertEnds(ExitCode.TROUBLE, "a.yaml: no such file or folder", new NoSuchFileException("a.yaml"));
    }

    @Test
    void failureOfACommandKeepsItsLinesAndItsCode() {
        assertEnds(ExitCode.BAD_INPUT, "one" + System.lineSeparator() + "two",
                new Failure(ExitCode.BAD_INPUT, List.of("one", "two")));
    }

    @Test
    void unexpectedExceptionIsNotSwallowed() {
        command.failure = new IllegalStateException("impossible");
        assertEquals(ExitCode.TROUBLE, execute(OptionStyle.SHELL, "try"));
        assertTrue(err.toString().contains("java.lang.IllegalStateException: impossible"), err.toString());
        assertTrue(err.toString().contains("at particles.app.cli.ProgramTest."), err.toString());
    }

    @Test
    void errorOfTheMachineIsNotSwallowed() {
        command.failure = new StackOverflowError("too deep");
        assertEquals(ExitCode.TROUBLE, execute(OptionStyle.SHELL, "try"));
        assertTrue(err.toString().contains("java.lang.StackOverflowError: too deep"), err.toString());
    }

    /** The memory estimate may be too small: running out of memory is also one line that says what to do. */
    @Test
    void fullMemoryIsOneLineAndCode1() {
        long most = Runtime.getRuntime().maxMemory();
        assertEnds(ExitCode.TROUBLE, "out of memory: Java may use " + (most >> 20)
                + " MiB; use fewer particles, frames or runs, or give Java more:"
                + " JAVA_TOOL_OPTIONS=-Xmx" + ((most >> 30) + 1)
                + "g", new OutOfMemoryError("Java heap space"));
    }

    @Test
    void exitCodesAreThoseOfTheReadme() {
        assertEquals(List.of(0, 1, 2, 3), List.of(ExitCode.values()).stream().map(ExitCode::code).toList());
    }

    @Test
    void everySolverHasItsLine() {
        assertEquals(ExitCode.DONE, execute(OptionStyle.SHELL, "solvers"));
        List<String> firstWords = out.toString().lines().map(line -> line.split(" ")[0]).toList();
        assertEquals(SolverCatalog.names(), firstWords);
        assertTrue(out.toString().lines().anyMatch(line -> line.matches("rk4 +order 4  The old workhorse.*")),
                out.toString());
    }
}
