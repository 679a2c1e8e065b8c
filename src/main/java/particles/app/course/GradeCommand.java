package particles.app.course;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import particles.app.cli.ResultsCommand;
import particles.app.course.Result.Item;
import particles.app.course.Result.Status;
import particles.app.student.StudentLoader;
import particles.output.files.TemporaryFolder;
import particles.spec.messages.InvalidInputException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/**
 * {@code gradle grade -Pstudent=ID}: marks all answers and all solvers of a student, as one report and for autograders.
 * With {@code -Phandin=FOLDER} it marks a hand-in as {@code gradeClass} does.
 */
@Command(name = Marking.PAGE, description = "Marks all answers and solvers of a student.")
public final class GradeCommand extends ResultsCommand {
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
        out.println(Marking.write(getFolder(), result) + "; report: " + getFolder().resolve(Marking.PAGE + ".md"));
        if (result.most() > 0) {                        // a script for VPL reads this line
            out.println("points: " + ClassTables.number(result.points()) + " of " + ClassTables.number(result.most()));
        }
        long missing = result.items().stream().filter(item -> item.status() != Status.PASS).count();
        if (missing > 0) {
            throw new InvalidInputException(result.most() == 0 ? missing + " still to hand in" : missing == 1
                    ? "one mark is missing" : missing + " marks are missing");
        }
    }

    /** The work in this project; the assignment says how much of the result is shown. */
    private Result own(Assignment assignment) throws Exception {
        Result all = new Marking(assignment, course.numbers(assignment, student), answers,
                StudentLoader.sources(folder), getFolder()).begin(student.strip(), new Submission("this project",
                Map.of(), Instant.EPOCH), "").get();
        return new Result(all.handIn(), all.program(), "", all.problems(), List.of(),
                all.items().stream().map(assignment::shown).toList());
    }

    private Result handedIn(Assignment assignment) throws Exception {
        try (TemporaryFolder copy = new TemporaryFolder("desolver-grade")) {
            Submission read = Submission.read(handIn);
            String id = student == null ? read.id() : student;      // null: not given
            return Marking.begin(id, read, assignment, course.numbers(assignment, id), getFolder(), copy.getPath())
                    .get();
        } catch (IOException e) {
            throw wrong("handin", "'" + handIn + "' cannot be read: " + e.getMessage());
        }
    }
}
