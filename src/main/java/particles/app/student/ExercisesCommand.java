package particles.app.student;

import java.io.PrintWriter;
import java.util.List;
import particles.app.cli.OptionStyle;
import particles.app.cli.ProgramCommand;
import particles.teaching.exercises.Exercises;
import particles.teaching.marking.Exercise;
import picocli.CommandLine.Command;

/** {@code gradle exercises}: lists the exercises, one line each. */
@Command(name = "exercises", description = "Lists the exercises.")
public final class ExercisesCommand extends ProgramCommand {
    private final OptionStyle style;

    /** @param style the way in which options are typed */
    public ExercisesCommand(OptionStyle style) {
        this.style = style;
    }

    @Override
    public void run(PrintWriter out) {
        List<Exercise> all = Exercises.all();
        for (int number = 1; number <= all.size(); number++) {
            out.printf("%2d  %s%n", number, all.get(number - 1).title());
        }
        out.println("the text with your own numbers: " + style.task("exercise") + " " + style.option("number") + "=1 "
                + style.option("student")
                + "=YOUR-ID");
    }
}
