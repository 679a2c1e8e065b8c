package particles.app.course;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import particles.app.cli.ResultsCommand;
import particles.app.course.Assignment.Shows;
import particles.app.course.Result.Item;
import particles.app.course.Result.State;
import particles.app.course.Result.Status;
import particles.spec.messages.InvalidInputException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code gradle grade -Pstudent=ID}: marks all answers and solvers in this project, for students and autograders. */
@Command(name = Marking.PAGE, description = "Marks all answers and solvers of a student.")
public final class GradeCommand extends ResultsCommand {
    @Option(names = "--student", paramLabel = "ID", required = true, description = "The student's id.")
    private String student;

    @Option(names = "--folder", paramLabel = "FOLDER", defaultValue = ".",
            description = "The folder of the student's work (default: this one).")
    private Path folder;

    @Mixin
    private final CourseOptions course = new CourseOptions();

    private final Path classes;

    /**
     * @param classes the folder of the student's classes
     */
    public GradeCommand(Path classes) {
        this.classes = classes;
    }

    @Override
    public void run(PrintWriter out) {
        if (student.isBlank()) {
            throw wrong("student", "the id is empty");
        }
        Assignment assignment = course.readAssignment();
        Submission work = Submission.read("this project", List.of(folder, classes));
        Result all = new Marking(assignment, course.numbersOf(assignment).apply(student), work, getFolder()).result(
                student.strip());
        Result result = Result.of(all.student(), State.MARKED, work, "", all.problems(), all.tests().stream().map(
                assignment::shown).toList());
        result.problems().forEach(out::println);
        for (Item item : result.tests()) {
            out.println((!item.answered() ? "missing   " : item.status() == Status.ERROR ? "undecided "
                    : assignment.shows() == Shows.HANDED_IN ? "handed in " : item.status() == Status.PASS ? "mark      "
                    : "no mark   ") + item.name());
            item.lines().stream().filter(line -> !line.equals(Marking.NO_ANSWER)).forEach(line -> out.println(
                    "            " + line));
        }
        Marking.write(getFolder(), result);
        out.println(result.summary() + " for " + result.student() + "; report: " + getFolder().resolve(Marking.PAGE
                + ".md"));
        if (result.maxScore() > 0) {                    // a script for VPL reads this line
            out.println("points: " + ClassTables.number(result.points()) + " of "
                    + ClassTables.number(result.maxScore()));
        }
        long missing = result.tests().stream().filter(item -> item.status() != Status.PASS).count();
        if (missing > 0) {
            throw new InvalidInputException(result.maxScore() == 0 ? missing + " still to hand in" : missing == 1
                    ? "one mark is missing" : missing + " marks are missing");
        }
    }
}
