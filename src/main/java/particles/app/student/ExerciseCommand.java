package particles.app.student;

import java.io.PrintWriter;
import java.util.Optional;
import particles.app.cli.ProgramCommand;
import particles.spec.messages.InvalidInputException;
import particles.teaching.exercises.Draw;
import particles.teaching.exercises.Exercise;
import particles.teaching.exercises.Exercise.Mark;
import particles.teaching.exercises.Exercises;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/**
 * {@code gradle exercise}: the list of exercises; with {@code -Pnumber=5 -Pstudent=ID} the text of one with the
 * student's own numbers, and with {@code -Panswer} the mark.
 */
@Command(name = "exercise",
        description = "Lists the exercises, shows one with numbers of your own, or marks your answer.")
public final class ExerciseCommand extends ProgramCommand {
    @Option(names = "--number", paramLabel = "NUMBER", description = "Which exercise (default: a list of all).")
    private Optional<Integer> number = Optional.empty();

    @Option(names = "--student", paramLabel = "ID", defaultValue = "",
            description = "Your id, from which your numbers come; needed with --number.")
    private String student;

    @Option(names = "--answer", paramLabel = "ANSWER",
            description = "Your answer: a number, or a scene's file in the last exercise.")
    private Optional<String> answer = Optional.empty();

    @Override
    public void run(PrintWriter out) {
        if (number.isEmpty()) {
            if (answer.isPresent()) {
                throw wrong("answer", "goes with " + getStyle().option("number") + " only");
            }
            Exercises.ALL.forEach(each -> out.printf("%2d  %s%n", Exercises.ALL.indexOf(each) + 1, each.title()));
            return;
        }
        int chosen = number.get();
        requireWithin("number", chosen, 1, Exercises.ALL.size());
        Exercise exercise = Exercises.ALL.get(chosen - 1);
        Draw draw = made("student", () -> new Draw(student, chosen));
        if (answer.isEmpty()) {
            out.println(chosen + ". " + exercise.title());
            out.println(exercise.text(draw));
            return;
        }
        Mark mark = exercise.mark(draw, answer.get());
        if (!mark.right()) {
            throw new InvalidInputException(mark.lines());
        }
        mark.lines().forEach(out::println);
    }
}
