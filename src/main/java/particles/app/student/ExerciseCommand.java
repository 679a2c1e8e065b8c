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
 * {@code gradle exercise -Pnumber=5 -Pstudent=ID}: the text with the student's own numbers; with {@code -Panswer} the
 * mark.
 */
@Command(name = "exercise", description = "Shows an exercise with numbers of your own, or marks your answer.")
public final class ExerciseCommand extends ProgramCommand {
    @Option(names = "--number", paramLabel = "NUMBER", required = true, description = "Which exercise.")
    private int number;

    @Option(names = "--student", paramLabel = "ID", required = true,
            description = "Your id, from which your numbers come.")
    private String student;

    @Option(names = "--answer", paramLabel = "ANSWER",
            description = "Your answer: a number, or a scene's file in the last exercise.")
    private Optional<String> answer;

    @Override
    public void run(PrintWriter out) {
        requireWithin("number", number, 1, Exercises.ALL.size());
        Exercise exercise = Exercises.ALL.get(number - 1);
        Draw draw = made("student", () -> new Draw(student, number));
        if (answer.isEmpty()) {
            out.println(number + ". " + exercise.title());
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
