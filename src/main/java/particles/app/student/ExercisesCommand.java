package particles.app.student;

import java.io.PrintWriter;
import particles.app.cli.ProgramCommand;
import particles.teaching.exercises.Exercises;
import picocli.CommandLine.Command;

/** {@code gradle exercises}: lists the exercises, one line each. */
@Command(name = "exercises", description = "Lists the exercises.")
public final class ExercisesCommand extends ProgramCommand {
    @Override
    public void run(PrintWriter out) {
        for (int number = 1; number <= Exercises.ALL.size(); number++) {
            out.printf("%2d  %s%n", number, Exercises.ALL.get(number - 1).title());
        }
    }
}
