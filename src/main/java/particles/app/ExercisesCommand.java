package particles.app;

import java.io.PrintWriter;
import java.util.List;
import particles.teaching.marking.Exercise;
import particles.teaching.exercises.Exercises;
import picocli.CommandLine.Command;

/** {@code gradle exercises}: the exercises, a line each. */
@Command(name = "exercises", description = "Lists the exercises.")
final class ExercisesCommand extends ProgramCommand {
    private final OptionStyle style;

    /** @param style how options are typed */
    ExercisesCommand(OptionStyle style) {
        this.style = style;
    }

    @Override
    void run(PrintWriter out) {
        List<Exercise> all = Exercises.all();
        for (int number = 1; number <= all.size(); number++) {
            out.printf("%2d  %s%n", number, all.get(number - 1).title());
        }
        out.println("the text with your own numbers: exercise " + style.option("number") + "=1 " + style.option("student")
                + "=YOUR-ID");
    }
}
