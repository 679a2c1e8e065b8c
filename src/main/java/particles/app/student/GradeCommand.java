package particles.app.student;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import particles.app.cli.ExitCode;
import particles.app.cli.Failure;
import particles.app.cli.ProgramCommand;
import particles.output.files.OutputFolder;
import particles.teaching.exercises.AnswersFile;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/**
 * {@code gradle grade -Pstudent=ID}: marks all answers and all solvers of a student, as one report and for autograders.
 */
@Command(name = GradeCommand.NAME, description = "Marks all answers and solvers of a student.")
public final class GradeCommand extends ProgramCommand {
    static final String NAME = Marking.PAGE;

    @Option(names = "--student", paramLabel = "ID", required = true, description = "The student's id.")
    private String student;

    @Option(names = "--answers", paramLabel = "FILE", defaultValue = "answers.yaml",
            description = "The file of answers, lines such as 5: 3.42 (default: answers.yaml).")
    private Path answers;

    @Mixin
    private final WantedClasses wanted = new WantedClasses();

    @Option(names = "--out", paramLabel = "FOLDER", defaultValue = "build/out/grade",
            description = "Where the report goes (default: build/out/grade).")
    private Path results;

    private final Path folder;

    /**
     * @param folder the folder of the student's classes
     */
    public GradeCommand(Path folder) {
        this.folder = folder;
    }

    @Override
    public void run(PrintWriter out) throws IOException {
        if (student.isBlank()) {
            throw wrong("student", "the id is empty");
        }
        try (OutputFolder files = OutputFolder.open(results, NAME + ".md", "marks.csv", "TEST-" + NAME + ".xml")) {
            Marking marking = new Marking(student, answers, StudentLoader.sources(folder), results);
            AnswersFile read = AnswersFile.read(answers);
            read.problems().forEach(out::println);
            List<Marking.Graded> graded = new ArrayList<>(marking.exercises(read));
            graded.addAll(marking.classes(wanted));
            graded.forEach(item -> item.print(out));
            out.println(marking.write(files, read.problems(), graded) + "; report: " + results.resolve(NAME + ".md"));
            long missing = graded.stream().filter(item -> !item.mark().right()).count();
            if (missing > 0) {
                throw new Failure(ExitCode.BAD_INPUT, missing == 1 ? "one mark is missing"
                        : missing + " marks are missing");
            }
        }
    }
}
