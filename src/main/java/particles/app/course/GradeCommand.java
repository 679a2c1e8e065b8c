package particles.app.course;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import particles.app.cli.ExitCode;
import particles.app.cli.Failure;
import particles.app.cli.ProgramCommand;
import particles.app.cli.Version;
import particles.app.course.Result.Item;
import particles.app.course.Result.Status;
import particles.app.student.StudentLoader;
import particles.teaching.exercises.AnswersFile;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/**
 * {@code gradle grade -Pstudent=ID}: marks all answers and all solvers of a student, as one report and for autograders.
 * With {@code -Phandin=FOLDER} it marks a hand-in as {@code gradeClass} does.
 */
@Command(name = GradeCommand.NAME, description = "Marks all answers and solvers of a student.")
public final class GradeCommand extends ProgramCommand {
    static final String NAME = Marking.PAGE;

    @Option(names = "--student", paramLabel = "ID", description = "The student's id.")
    private String student;

    @Option(names = "--handin", paramLabel = "FOLDER",
            description = "A folder or zip that was handed in, in place of this project; the id may be left out.")
    private Path handIn;

    @Option(names = "--answers", paramLabel = "FILE", defaultValue = "answers.yaml",
            description = "The file of answers, lines such as 5: 3.42 (default: answers.yaml).")
    private Path answers;

    @Mixin
    private final CourseOptions course = new CourseOptions();

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
    public void run(PrintWriter out) throws Exception {
        if (student == null && handIn == null || student != null && student.isBlank()) {    // null: not given
            throw wrong("student", "the id is " + (student == null ? "missing" : "empty"));
        }
        Assignment assignment = course.assignment();
        Result result = handIn == null ? own(assignment) : handedIn(assignment);
        result.problems().forEach(out::println);
        for (Item item : result.items()) {
            out.println((!item.answered() ? "missing   " : item.status() == Status.PASS ? assignment.showsMarks()
                    || handIn != null ? "mark      " : "handed in " : item.status() == Status.ERROR ? "undecided "
                    : "no mark   ") + item.name());
            if (!item.lines().contains(Marking.NO_ANSWER)) {
                item.lines().forEach(line -> out.println("            " + line));
            }
        }
        out.println(Marking.write(results, result) + "; report: " + results.resolve(NAME + ".md"));
        if (result.most() > 0) {                        // a script for VPL reads this line
            out.println("points: " + ClassTables.number(result.points()) + " of " + ClassTables.number(result.most()));
        }
        long missing = result.items().stream().filter(item -> item.status() != Status.PASS).count();
        if (missing > 0) {
            throw new Failure(ExitCode.BAD_INPUT, result.most() == 0 ? missing + " still to hand in" : missing == 1
                    ? "one mark is missing" : missing + " marks are missing");
        }
    }

    /** The work in this project; the assignment says how much of the result is shown. */
    private Result own(Assignment assignment) throws IOException {
        Marking marking = new Marking(assignment, course.numbers(assignment, student), answers,
                StudentLoader.sources(folder), results);
        AnswersFile read = AnswersFile.read(answers);
        List<Item> items = new ArrayList<>(marking.exercises(read));
        items.addAll(marking.classes());
        return new Result(student.strip(), "this project", Instant.EPOCH, Version.CURRENT, "",
                marking.withoutFolder(read.problems()), List.of(), items.stream().map(assignment::shown).toList());
    }

    private Result handedIn(Assignment assignment) throws Exception {
        Path copy = Files.createTempDirectory("desolver-grade");
        try {
            Submission read = Submission.read(handIn);
            String id = student == null ? read.id() : student;      // null: not given
            return HandInMarking.begin(id, Optional.of(read), assignment, course.numbers(assignment, id), results,
                    copy).call();
        } catch (IOException e) {
            throw wrong("handin", "'" + handIn + "' cannot be read: " + e.getMessage());
        } finally {
            HandInMarking.delete(copy);
        }
    }
}
