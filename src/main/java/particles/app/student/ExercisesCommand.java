package particles.app.student;

import java.io.PrintWriter;
import java.util.List;
import particles.app.cli.ProgramCommand;
import particles.teaching.exercises.Exercise;
import particles.teaching.exercises.Exercises;
import picocli.CommandLine.Command;

/** {@code gradle exercises}: lists the exercises, one line each. */
@Command(name = "exercises", description = "Lists the exercises.")
public final class ExercisesCommand extends ProgramCommand {
    @Override
    public void run(PrintWriter out) {
        List<Exercise> all = Exercises.ALL;
        for (int number = 1; number <= all.size(); number++) {
            out.printf("%2d  %s%n", number, all.get(number - 1).title());
        }
    }
}
