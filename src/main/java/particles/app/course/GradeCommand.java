package particles.app.course;

import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import particles.app.cli.ResultsCommand;
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

    @Mixin
    private final CourseOptions course = new CourseOptions();

    private final List<Path> folders;

    /** @param folders the folders of the student's work and classes */
    public GradeCommand(Path... folders) {
        this.folders = List.of(folders);
    }

    @Override
    public void run(PrintWriter out) {
        if (student.isBlank()) {
            throw wrong("student", "the id is empty");
        }
        Assignment assignment = course.readAssignment();
        Submission work = Submission.read("this project", folders.stream().filter(Files::isDirectory).toList());
        Result result = new Marking(assignment, course.numbersOf(assignment).apply(student), work, getFolder()).result(
                Optional.of(student.strip()));
        if (result.state() != State.MARKED) {
            Marking.write(getFolder(), result);
            throw new InvalidInputException(result.reason());
        }
        result.problems().forEach(out::println);
        for (Item item : result.tests()) {
            out.println((!item.answered() ? "missing   " : switch (item.status()) {
                case PASS -> "mark      ";
                case FAIL -> "no mark   ";
                case ERROR -> "undecided ";
            }) + item.name());
            item.message().lines().filter(line -> !line.equals(Marking.NO_ANSWER)).forEach(line -> out.println(
                    "            " + line));
        }
        Marking.write(getFolder(), result);
        // a script for VPL reads the points
        out.println(result.summary() + "; report: " + getFolder().resolve(Marking.PAGE + ".md"));
        long missing = result.tests().stream().filter(item -> item.status() != Status.PASS).count();
        if (missing > 0) {
            throw new InvalidInputException("marks that are missing: " + missing);
        }
    }
}
