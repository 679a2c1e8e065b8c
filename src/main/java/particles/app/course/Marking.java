package particles.app.course;

import static particles.view.DataTable.column;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
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
import particles.output.report.JUnitXml;
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
 * @param numbers    the text from which the numbers of each exercise come, from place 1 on; empty if that is not known
 * @param handIn     what was handed in
 * @param folder     the folder of the result
 */
record Marking(Assignment assignment, List<String> numbers, Submission handIn, Path folder) {
    static final String PAGE = "grade";
    static final String NO_ANSWER = "There is no answer.";
    private static final double SECONDS = 60;

    private AnswersFile answers() {
        return handIn.answers().stream().findFirst().map(path -> AnswersFile.read(path, handIn.files().get(path)
                .text())).orElse(new AnswersFile(Map.of(), List.of("there is no " + Submission.ANSWERS)));
    }

    /**
     * Marks the hand-in, unless the same one was marked before; then that result is kept.
     *
     * @param student the id
     * @return the result
     */
    Result result(String student) {
        String digest = Digest.of(Program.VERSION + '\0' + assignment + '\0' + numbers + handIn.files().keySet()
                + handIn.files().values().stream().map(Submission.Text::text).toList());
        Optional<Result> earlier = Result.read(folder.resolve(Result.FILE)).filter(result -> result.digest().equals(
                digest) && result.student().equals(student) && result.status() != Status.ERROR);
        return Result.of(student, State.MARKED, handIn, digest, Stream.concat(handIn.remarks().stream(),
                answers().problems().stream()).toList(), earlier.map(Result::tests).orElseGet(this::items));
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
                    : mark.right() ? Status.PASS : Status.FAIL, weight, mark.lines()));
        });
        Map<String, String> sources = handIn.sources();
        assignment.solvers(sources.keySet()).forEach((name, asked) -> items.add(check(sources, "solver", name,
                new Check(CheckSolverCommand.NAME, "exercises." + name, asked.method(), ChartFormat.PAGE),
                asked.weight())));
        assignment.effects().forEach((name, weight) -> items.add(check(sources, "effect", name, new Check(
                CheckEffectCommand.NAME, "exercises." + name, "", ChartFormat.PAGE), weight)));
        return items;
    }

    private Mark mark(Exercise exercise, int number, String answer) {
        GuardedRun.Outcome<Mark> marked = new GuardedRun(SECONDS).run(() -> exercise.mark(new Draw(numbers.get(number),
                number), answer, handIn::file));
        return marked.value().orElseGet(() -> Mark.wrong(marked.failure().orElseThrow().text()));
    }

    private Item check(Map<String, String> sources, String kind, String name, Check check, double weight) {
        boolean there = sources.containsKey(name);
        StudentProcess.Outcome outcome = there ? StudentProcess.run(check, folder.resolve(name), sources)
                : new StudentProcess.Outcome(ExitCode.BAD_INPUT, List.of("there is no file " + name + ".java"));
        return Item.of(kind + " " + name, there, outcome.code() == ExitCode.DONE ? Status.PASS : outcome.code()
                == ExitCode.STOPPED ? Status.ERROR : Status.FAIL, weight, new Mark(false, outcome.lines().stream()
                .map(line -> line.replace(folder + "/", "")).toList()).lines());
    }

    /** Writes the student's page, grade.md, with marks.csv, grade.json and TEST-grade.xml. */
    static void write(Path folder, Result result) {
        DataTable table = DataTable.of("marks", "Marks", result.tests(),
                column("exercise", Item::name),
                column("points", item -> ClassTables.number(item.score())),
                column("of", item -> ClassTables.number(item.maxScore())),
                column("comments", item -> String.join("; ", item.lines()).replaceAll("(?<=[.:]); ", " ")));
        List<String> names = List.of(PAGE + ".md", "marks.csv", Result.FILE, "TEST-" + PAGE + ".xml");
        clear(folder, names);
        try (OutputFolder files = OutputFolder.open(folder, names.toArray(new String[0]))) {
            new ResultPage(PAGE, result.summary() + " for " + result.student(), result.problems(), List.of(),
                    List.of(table)).write(files, ChartFormat.PAGE);
            JUnitXml.write(files, PAGE, result.student(), result.tests().stream().map(item -> new JUnitXml.Case(
                    item.name(), Optional.of(item.message()).filter(line -> item.status() != Status.PASS),
                    item.lines())).toList());
            files.write(Result.FILE, result.json());
        }
    }

    /** Moves aside what a class put, as a folder, in the place of a file. */
    static void clear(Path folder, List<String> names) {
        for (String name : names) {
            Path file = folder.resolve(name);
            if (Files.isDirectory(file, LinkOption.NOFOLLOW_LINKS)) {
                try {
                    Files.move(file, folder.resolve(name + "-moved-aside-" + System.nanoTime()));
                } catch (IOException e) {
                    throw new UncheckedIOException(e);
                }
            }
        }
    }
}
