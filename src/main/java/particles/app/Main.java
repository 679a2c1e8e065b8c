package particles.app;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.Charset;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import particles.app.cli.ExitCode;
import particles.app.cli.OptionStyle;
import particles.app.cli.Program;
import particles.app.cli.ProgramCommand;
import particles.app.cli.ResultsCommand;
import particles.app.course.AutogradingCommand;
import particles.app.course.GradeClassCommand;
import particles.app.course.GradeCommand;
import particles.app.course.SheetsCommand;
import particles.app.experiments.ReportCommand;
import particles.app.experiments.SweepCommand;
import particles.app.run.GalleryCommand;
import particles.app.run.LabCommand;
import particles.app.run.RunCommand;
import particles.app.run.ScenesCommand;
import particles.app.run.SolversCommand;
import particles.app.run.StopRequest;
import particles.app.student.CheckEffectCommand;
import particles.app.student.CheckSolverCommand;
import particles.app.student.ExerciseCommand;
import particles.app.student.NewClassCommand;
import particles.app.student.StudentLoader;
import particles.output.files.OutputException;
import particles.output.report.ResultsIndex;

/**
 * The main class of the program: {@code desolver COMMAND --option=value ...}, or {@code gradle COMMAND -Poption=value
 * ...}.
 */
public final class Main {
    private static final Path SCENES = Path.of("scenes");
    private static final Path EXERCISES = Path.of("src", "main", "java", "exercises");

    private Main() {
    }

    /** @param args a command and its options */
    public static void main(String[] args) {
        StopRequest stop = new StopRequest();
        stop.listen(System.err);
        System.setProperty("java.awt.headless", "true");
        new StudentLoader(exercises()).install();
        List<ProgramCommand> commands = commands(stop);
        stop.setLine(() -> commands.stream().filter(command -> args.length > 0
                && command.name().equals(args[0])).findFirst().map(ProgramCommand::whenStopped).orElse("stopped"));
        Charset letters = Charset.defaultCharset();     // of the terminal
        Program program = new Program(commands, OptionStyle.current(),
                new PrintWriter(stop.untilCutOff(new StandardOutput()), true, letters),
                new PrintWriter(stop.untilCutOff(System.err), true, letters));
        ExitCode code = program.execute(args);
        try {
            ResultsIndex.update(ResultsCommand.RESULTS);
        } catch (OutputException e) {                   // the results themselves are written
            System.err.println(e.getMessage());
        }
        stop.end(code, System::exit);
    }

    /** The folder of students' classes; a check in a process of its own receives it. */
    private static Path exercises() {
        return Path.of(System.getProperty(StudentLoader.FOLDER, EXERCISES.toString()));
    }

    /**
     * @param stop  tells commands when they have to end early
     * @return all commands, in the order in which help lists them; build.gradle has a task for each
     */
    public static List<ProgramCommand> commands(StopRequest stop) {
        List<ProgramCommand> commands = new ArrayList<>(List.of(new RunCommand(SCENES, stop),
                new ScenesCommand(SCENES), new GalleryCommand(SCENES), new SolversCommand()));
        commands.addAll(ReportCommand.experiments());
        commands.addAll(List.of(new SweepCommand(), new ReportCommand(), new LabCommand(SCENES, exercises()),
                new CheckSolverCommand(), new NewClassCommand.NewSolver(exercises()),
                new NewClassCommand.NewEffect(exercises()), new CheckEffectCommand(),
                new ExerciseCommand(), new GradeCommand(Path.of("."), exercises()), new GradeClassCommand(),
                new SheetsCommand(), new AutogradingCommand()));
        return commands;
    }

    /** Standard output. If it goes to a program that reads no further, as {@code head} does, the rest is dropped. */
    private static final class StandardOutput extends FileOutputStream {
        private static final Path DEVICE = Path.of("/dev/stdout");
        private static final int FILE_TYPE = 0xf000;
        private static final int PIPE = 0x1000;

        StandardOutput() {
            super(FileDescriptor.out);
        }

        @Override
        public void write(byte[] bytes, int offset, int length) throws IOException {
            try {
                super.write(bytes, offset, length);
            } catch (IOException e) {
                if (!isPipe()) {
                    throw e;                                // a full disk, for example
                }
            }
        }

        /** Asks for the kind of file, since the message of an exception depends on the user's language. */
        private static boolean isPipe() throws IOException {
            return Files.exists(DEVICE) && ((int) Files.getAttribute(DEVICE, "unix:mode") & FILE_TYPE) == PIPE;
        }
    }
}
