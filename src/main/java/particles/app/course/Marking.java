package particles.app.course;

import static particles.view.DataTable.column;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import particles.app.cli.ExitCode;
import particles.app.cli.Program;
import particles.app.course.Result.HandIn;
import particles.app.course.Result.Item;
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
import particles.spec.messages.InvalidInputException;
import particles.teaching.GuardedRun;
import particles.teaching.GuardedRun.Outcome;
import particles.teaching.exercises.AnswersFile;
import particles.teaching.exercises.Draw;
import particles.teaching.exercises.Exercise;
import particles.teaching.exercises.Exercise.Mark;
import particles.teaching.exercises.Exercises;
import particles.view.DataTable;

/**
 * The marking of one hand-in, in two parts: the answers at once, the classes later, when no answers are left to mark.
 *
 * @param assignment what counts
 * @param numbers    the text from which the numbers of each exercise come, from place 1 on; empty if that is not known
 * @param answers    the file of answers
 * @param sources    the text of each class that was handed in
 * @param reports    the folder of the reports
 */
record Marking(Assignment assignment, List<String> numbers, Path answers, Map<String, String> sources,
        Path reports) {
    static final String PAGE = "grade";
    static final String NO_ANSWER = "There is no answer.";
    private static final double SECONDS = 60;

    /**
     * Marks the answers. Where the same hand-in was marked before, it takes that result.
     *
     * @param student    the id
     * @param handIn     what was handed in
     * @param assignment what counts
     * @param numbers    the text from which the numbers of each exercise come; empty if that is not known
     * @param results    the folder of the result
     * @param copy       a new folder, which stays until the classes have run
     * @return what runs the classes and makes the result
     * @throws IOException if a file cannot be written
     */
    static Supplier<Result> begin(String student, Submission handIn, Assignment assignment, List<String> numbers,
            Path results, Path copy) throws IOException {
        String digest = Digest.of(Program.VERSION + '\0' + assignment + '\0' + numbers + handIn.digest());
        Optional<Result> earlier = earlier(results.resolve(Result.FILE)).filter(result -> result.isDecided()
                && result.digest().equals(digest) && result.student().equals(student));
        if (earlier.isPresent()) {
            Result same = earlier.get();                // downloaded again, it may have another date
            return () -> new Result(new HandIn(student, handIn.name(), handIn.newest()), same.program(), digest,
                    same.problems(), same.classes(), same.items());
        }
        Files.createDirectories(copy);
        return new Marking(assignment, numbers, handIn.copyAnswers(copy), handIn.sources(), results).begin(student,
                handIn, digest);
    }

    /** The result of an earlier run; a damaged one is none. */
    private static Optional<Result> earlier(Path file) {
        try {
            return Files.isRegularFile(file) ? Optional.of(Result.read(file)) : Optional.empty();
        } catch (InvalidInputException damaged) {
            return Optional.empty();
        }
    }

    /**
     * Marks the answers, which runs no class of the student.
     *
     * @param digest of everything on which the result depends
     * @return what runs the classes and makes the result
     */
    Supplier<Result> begin(String student, Submission handIn, String digest) {
        AnswersFile read = AnswersFile.read(answers);
        List<Item> items = exercises(read.answers());
        List<String> problems = Stream.concat(handIn.problems().stream(), withoutFolder(read.problems()).stream())
                .toList();
        return () -> {
            items.addAll(classes());
            return new Result(new HandIn(student, handIn.name(), handIn.newest()), Program.VERSION, digest, problems,
                    Copies.of(sources), items);
        };
    }

    /** The marks of the answers, where their numbers are known. */
    private List<Item> exercises(Map<Integer, String> given) {
        List<Item> items = new ArrayList<>();
        assignment.exercises().forEach((number, weight) -> {
            Exercise exercise = Exercises.ALL.get(number - 1);
            Optional<String> answer = Optional.ofNullable(given.get(number));      // null: no answer
            boolean undecided = answer.isPresent() && numbers.isEmpty();
            Mark mark = answer.isEmpty() ? Mark.wrong(NO_ANSWER) : undecided ? Mark.wrong(
                    "Its numbers are on your handout: it is marked with the lecturer's key file.")
                    : mark(exercise, number, answer.get());
            items.add(new Item(number + ". " + exercise.title(), answer.isPresent(), undecided ? Status.ERROR
                    : mark.right() ? Status.PASS : Status.FAIL, weight, withoutFolder(mark.lines())));
        });
        return items;
    }

    /** The lines, with files named as they were handed in. */
    private List<String> withoutFolder(List<String> lines) {
        String folder = answers.toAbsolutePath().getParent().toString().replace('\\', '/') + "/";
        return lines.stream().map(line -> line.replace(folder, "")).toList();
    }

    /** A scene's path is relative to the folder of the answers, which it cannot leave; both are handed in together. */
    private Mark mark(Exercise exercise, int number, String answer) {
        Draw draw = new Draw(numbers.get(number), number);
        if (number < Exercises.ALL.size() || answer.isBlank()) {
            return exercise.mark(draw, answer);
        }
        try {
            Path folder = answers.toAbsolutePath().normalize().getParent();
            Path scene = folder.resolve(answer.strip()).normalize();
            if (!scene.startsWith(folder) || Files.exists(scene)
                    && !scene.toRealPath().equals(folder.toRealPath().resolve(folder.relativize(scene)))) {
                return Mark.wrong("'" + answer.strip() + "' is outside of the folder of " + answers.getFileName()
                        + ", or a link: hand the scene's file in beside it.");
            }
            Outcome<Mark> marked = new GuardedRun(SECONDS).run(() -> exercise.mark(draw,
                    answers.resolveSibling(answer.strip()).toString()));
            return marked.value().orElseGet(() -> Mark.wrong(marked.failure().orElseThrow().text()));
        } catch (IOException | InvalidPathException e) {
            return Mark.wrong("'" + answer.strip() + "' cannot be read: " + e.getMessage());
        }
    }

    private List<Item> classes() {
        List<Item> items = new ArrayList<>();
        assignment.solvers(sources.keySet()).forEach((name, asked) -> items.add(check("solver", CheckSolverCommand.NAME,
                name, asked.method(), asked.weight())));
        assignment.effects().forEach((name, weight) -> items.add(check("effect", CheckEffectCommand.NAME, name, "",
                weight)));
        return items;
    }

    private Item check(String kind, String command, String name, String method, double weight) {
        boolean there = sources.containsKey(name);
        StudentProcess.Outcome outcome = there ? StudentProcess.run(new Check(command, "exercises." + name, method,
                ChartFormat.PAGE), reports.resolve(name), sources) : new StudentProcess.Outcome(ExitCode.BAD_INPUT,
                List.of("there is no file " + name + ".java"));
        return new Item(kind + " " + name, there, outcome.code() == ExitCode.DONE ? Status.PASS : outcome.code()
                == ExitCode.STOPPED ? Status.ERROR : Status.FAIL, weight, new Mark(false, outcome.lines()).lines());
    }

    /** Joins lines for a table's cell; sentences and headings stay on lines of their own. */
    private static String paragraph(List<String> lines) {
        return lines.stream().map(line -> line.strip().replaceAll(" {2,}", ": "))      // columns of the check's table
                .collect(Collectors.joining("; ")).replaceAll("(?<=[.:]); ", " ");
    }

    /**
     * Writes the student's page, grade.md, with marks.csv, grade.json and TEST-grade.xml.
     *
     * @return how many points there are, in words
     */
    static String write(Path folder, Result result) {
        String title = result.summary() + " for " + result.student();
        DataTable table = DataTable.of("marks", "Marks", result.items(),
                column("student", item -> result.student()), column("exercise", Item::name),
                column("points", item -> ClassTables.number(item.points())),
                column("of", item -> ClassTables.number(item.weight())),
                column("what there is to say", item -> paragraph(item.lines()).replace(": " + folder + "/", ": ")));
        List<String> names = List.of(PAGE + ".md", "marks.csv", Result.FILE, "TEST-" + PAGE + ".xml");
        clear(folder, names);
        try (OutputFolder files = OutputFolder.open(folder, names.toArray(new String[0]))) {
            new ResultPage(PAGE, title, result.problems(), List.of(), List.of(table)).write(files, ChartFormat.PAGE);
            JUnitXml.write(files, PAGE, result.student(), result.items().stream().map(item -> new JUnitXml.Case(
                    item.name(), item.status() == Status.PASS ? Optional.empty() : Optional.of(item.lines().stream()
                    .findFirst().orElse("")), item.lines())).toList());
            files.write(Result.FILE, result.json());
        }
        return title;
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
