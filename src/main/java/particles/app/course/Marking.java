package particles.app.course;

import static particles.view.DataTable.column;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import particles.app.cli.ExitCode;
import particles.app.cli.Program;
import particles.app.course.Result.Item;
import particles.app.course.Result.State;
import particles.app.course.Result.Status;
import particles.app.student.Check;
import particles.app.student.CheckEffectCommand;
import particles.app.student.CheckSolverCommand;
import particles.app.student.StudentProcess;
import particles.output.charts.ChartFormat;
import particles.output.files.OutputFolder;
import particles.output.report.ResultPage;
import particles.spec.Digest;
import particles.teaching.GuardedRun;
import particles.teaching.exercises.AnswersFile;
import particles.teaching.exercises.Draw;
import particles.teaching.exercises.Exercise;
import particles.teaching.exercises.Exercise.Mark;
import particles.teaching.exercises.Exercises;
import particles.view.DataTable;

/**
 * The marking of one hand-in.
 *
 * @param assignment what counts
 * @param numbers    the text from which the numbers of the exercises come; empty if that is not known
 * @param handIn     what was handed in
 * @param folder     the folder of the result
 */
record Marking(Assignment assignment, Optional<String> numbers, Submission handIn, Path folder) {
    static final String PAGE = "grade";
    static final String NO_ANSWER = "There is no answer.";
    private static final double SECONDS = 60;

    private AnswersFile answers() {
        return handIn.answers().stream().findFirst().map(path -> AnswersFile.read(path, handIn.files().get(path)))
                .orElse(new AnswersFile(Map.of(), List.of("there is no " + Submission.ANSWERS)));
    }

    /** @return the fingerprint of everything on which the result depends; dates of files are not in it */
    String digest() {
        return Digest.of(Program.VERSION + assignment + numbers + handIn.files() + handIn.others() + handIn.damaged());
    }

    /**
     * Marks the hand-in.
     *
     * @param student the student's id; empty if nobody's. Then, and for a damaged hand-in, there are no marks
     */
    Result result(Optional<String> student) {
        State state = student.isEmpty() ? State.WHOSE : !handIn.damaged().isEmpty() ? State.UNREADABLE
                : handIn.name().isEmpty() ? State.NOTHING : State.MARKED;
        return Result.of(student.orElse(handIn.name()), state, handIn, digest(), state == State.MARKED
                ? Stream.concat(handIn.remarks().stream(), answers().problems().stream()).toList() : handIn.damaged(),
                state.compareTo(State.NOTHING) < 0 ? List.of() : items());
    }

    /** All marks: first the answers, then the classes, each of which runs in a process of its own. */
    List<Item> items() {
        List<Item> items = new ArrayList<>();
        Map<Integer, String> answers = answers().answers();
        assignment.exercises().forEach((number, weight) -> {
            Exercise exercise = Exercises.ALL.get(number - 1);
            Optional<String> answer = Optional.ofNullable(answers.get(number));      // null: no answer
            boolean undecided = answer.isPresent() && numbers.isEmpty();
            Mark mark = answer.isEmpty() ? Mark.wrong(NO_ANSWER) : undecided ? Mark.wrong(
                    "Its numbers are on your handout: it is marked with the lecturer's key file.")
                    : mark(exercise, number, answer.get());
            items.add(Item.of(number + ". " + exercise.title(), answer.isPresent(), undecided ? Status.ERROR
                    : mark.right() ? Status.PASS : Status.FAIL, weight, mark));
        });
        Map<String, String> sources = handIn.sources();
        assignment.solvers(sources.keySet()).forEach((name, asked) -> items.add(check(sources, "solver", name,
                new Check(CheckSolverCommand.NAME, "exercises." + name, asked.method()),
                asked.weight())));
        assignment.effects().forEach((name, weight) -> items.add(check(sources, "effect", name, new Check(
                CheckEffectCommand.NAME, "exercises." + name, ""), weight)));
        return items;
    }

    private Mark mark(Exercise exercise, int number, String answer) {
        GuardedRun.Outcome<Mark> marked = new GuardedRun(SECONDS).run(() -> exercise.mark(new Draw(
                numbers.orElseThrow(), number), answer, handIn::file));
        return marked.value().orElseGet(() -> Mark.wrong(marked.failure().orElseThrow().text()));
    }

    private Item check(Map<String, String> sources, String kind, String name, Check check, double weight) {
        boolean there = sources.containsKey(name);
        StudentProcess.Outcome outcome = there ? StudentProcess.run(check, folder.resolve(name), sources)
                : new StudentProcess.Outcome(ExitCode.BAD_INPUT, List.of("there is no file " + name + ".java"));
        return Item.of(kind + " " + name, there, outcome.code() == ExitCode.DONE ? Status.PASS : outcome.code()
                == ExitCode.STOPPED ? Status.ERROR : Status.FAIL, weight, new Mark(false, outcome.lines().stream()
                .map(line -> line.replace(folder + "/", "")).toList()));
    }

    /** Writes the student's page, grade.md, with marks.csv and grade.json. */
    static void write(Path folder, Result result) {
        DataTable table = DataTable.of("marks", "Marks", result.tests(),
                column("exercise", Item::name),
                column("points", Item::score), column("of", Item::maxScore),
                column("comments", item -> item.message().lines().collect(Collectors.joining(" / "))));
        try (OutputFolder files = OutputFolder.open(folder)) {
            new ResultPage(PAGE, result.summary(), result.problems(), List.of(), List.of(table)).write(files,
                    ChartFormat.PAGE);
            files.write(Result.FILE, result.json());
        }
    }
}
