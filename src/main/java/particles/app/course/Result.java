package particles.app.course;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import particles.app.cli.ExitCode;
import particles.app.cli.Failure;
import particles.spec.FlagType;
import particles.spec.Key;
import particles.spec.ListType;
import particles.spec.MappingType;
import particles.spec.NumberType;
import particles.spec.Reading;
import particles.spec.SourceText;
import particles.spec.TextType;
import particles.spec.Type;
import particles.spec.Values;
import particles.spec.YamlText;
import particles.spec.documents.JsonText;
import particles.spec.messages.Problems;

/**
 * The result of one hand-in: the file grade.json. {@code status}, {@code max_score} and {@code tests} are those that
 * the autograding reporter of GitHub Classroom reads; the other keys are ours.
 *
 * @param student  the student's id
 * @param handedIn the name of the folder or zip; empty if nothing was handed in
 * @param date     the latest date of a file in it
 * @param program  the version of the program
 * @param digest   of everything on which the result depends
 * @param problems lines on what could not be read
 * @param classes  each class that was handed in, as {@link Copies} knows it
 * @param items    the marks
 */
record Result(String student, String handedIn, Instant date, String program, String digest,
        List<String> problems, List<String> classes, List<Item> items) {
    static final String FILE = "grade.json";
    private static final Type<String> TEXT = TextType.typed("a text");
    private static final Key<String> NAME = TEXT.required("name", "Its name.");
    private static final Key<String> STATUS = TEXT.required("status", "One of pass, fail, error.");
    private static final Key<Double> SCORE = NumberType.notNegative("").required("score", "The points.");
    private static final Key<Double> MOST = NumberType.notNegative("").required("max_score", "The most points.");
    private static final Key<Boolean> ANSWERED = FlagType.FLAG.required("answered", "Whether it was handed in.");
    private static final Key<String> MESSAGE = TEXT.required("message", "The first line of comment.");
    private static final Key<List<String>> MORE = ListType.of("a line", TEXT).required("more", "Further lines.");
    private static final Key<Double> LINE = NumberType.notNegative("").required("line_no", "0: none.");
    private static final Key<List<Values>> TESTS = ListType.of("a test", MappingType.of("a test", NAME, STATUS, SCORE,
            MOST, ANSWERED, MESSAGE, MORE, LINE)).required("tests", "The marks.");
    private static final Key<String> STUDENT = TEXT.required("student", "The id.");
    private static final Key<String> HANDED_IN = TEXT.required("handedIn", "The name of the hand-in.");
    private static final Key<String> DATE = TEXT.required("date", "Its date.");
    private static final Key<String> DIGEST = TEXT.required("digest", "Of all on which the result depends.");
    private static final Key<String> PROGRAM = TEXT.required("program", "The version of the program.");
    private static final Key<List<String>> PROBLEMS = ListType.of("a line", TEXT).required("problems", "Lines.");
    private static final Key<List<String>> CLASSES = ListType.of("a class", TEXT).required("classes", "Shapes.");
    private static final MappingType FORMAT = MappingType.of("the result", NumberType.any("").required("version",
            "Of the format of tests."), STATUS, MOST, TESTS, STUDENT, HANDED_IN, DATE, DIGEST, PROGRAM, PROBLEMS,
            CLASSES);

    /**
     * A mark.
     *
     * @param name     the exercise or class
     * @param answered whether it was handed in
     * @param status   the mark; not decided if the machine was too busy
     * @param weight   the most points
     * @param lines    the comments
     */
    record Item(String name, boolean answered, Status status, double weight, List<String> lines) {
        double points() {
            return status == Status.PASS ? weight : 0;
        }

        /** @return the first mistake */
        String mistake() {
            return status == Status.PASS || lines.isEmpty() ? "" : lines.stream()
                    .filter(line -> line.matches("(WRONG|PROMISE), .*")).findFirst().orElse(lines.get(0));
        }
    }

    /** Right, wrong or missing, not decided. */
    enum Status {
        PASS, FAIL, ERROR;

        String word() {
            return name().toLowerCase(Locale.ROOT);
        }
    }

    /** @return right if all marks are */
    Status status() {
        return !isDecided() ? Status.ERROR : items.stream().allMatch(item -> item.status == Status.PASS) ? Status.PASS
                : Status.FAIL;
    }

    double points() {
        return items.stream().mapToDouble(Item::points).sum();
    }

    double most() {
        return items.stream().mapToDouble(Item::weight).sum();
    }

    boolean isDecided() {
        return items.stream().noneMatch(item -> item.status == Status.ERROR);
    }

    /** @return the contents of the file */
    String json() {
        return JsonText.of(map("version", 1, "status", status().word(), "max_score", most(),
                "tests", items.stream().map(item -> map("name", item.name, "status", item.status.word(),
                "score", item.points(), "max_score", item.weight, "answered", item.answered, "message",
                item.lines.isEmpty() ? "" : item.lines.get(0), "more", item.lines.stream().skip(1).toList(),
                "line_no", 0)).toList(), "student", student, "handedIn", handedIn, "date", date.toString(),
                "digest", digest, "program", program, "problems", problems, "classes", classes));
    }

    private static Map<String, Object> map(Object... keysAndValues) {
        Map<String, Object> map = new LinkedHashMap<>();
        for (int k = 0; k < keysAndValues.length; k += 2) {
            map.put((String) keysAndValues[k], keysAndValues[k + 1]);
        }
        return map;
    }

    /**
     * @param file a file with a result
     * @return the result
     * @throws Failure with a line for each mistake if it is none
     */
    static Result read(Path file) {
        Problems problems = new Problems();
        Reading in = new Reading(file.toString().replace('\\', '/'), problems);
        Optional<Values> read = SourceText.read(file, in).flatMap(bytes -> YamlText.compose(bytes, in))
                .map(root -> FORMAT.readRoot(root, in));
        if (problems.count() > 0) {
            throw new Failure(ExitCode.BAD_INPUT, problems.lines());
        }
        Values all = read.orElseThrow();
        return new Result(all.get(STUDENT), all.get(HANDED_IN), Instant.parse(all.get(DATE)), all.get(PROGRAM),
                all.get(DIGEST), all.get(PROBLEMS), all.get(CLASSES), all.get(TESTS).stream().map(Result::item)
                .toList());
    }

    private static Item item(Values test) {
        return new Item(test.get(NAME), test.get(ANSWERED), Status.valueOf(test.get(STATUS).toUpperCase(Locale.ROOT)),
                test.get(MOST), test.get(MESSAGE).isEmpty() ? List.of() : Stream.concat(Stream.of(test.get(MESSAGE)),
                test.get(MORE).stream()).toList());
    }

    /** @return all results in the folders of this folder */
    static List<Result> readAll(Path folder) throws IOException {
        try (Stream<Path> folders = Files.list(folder)) {
            return folders.map(each -> each.resolve(FILE)).filter(Files::isRegularFile).sorted().map(Result::read)
                    .toList();
        }
    }
}
