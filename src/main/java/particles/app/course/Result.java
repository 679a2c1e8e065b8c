package particles.app.course;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import particles.spec.JsonText;
import particles.spec.Ordered;
import particles.spec.messages.InvalidInputException;

/**
 * The result of one hand-in: the file grade.json. {@code status}, {@code max_score} and {@code tests} are those that
 * the autograding reporter of GitHub Classroom reads; the other keys are ours.
 *
 * @param handIn   what was marked
 * @param program  the version of the program
 * @param digest   of everything on which the result depends
 * @param problems lines on what could not be read
 * @param classes  each class that was handed in, as {@link Copies} knows it
 * @param items    the marks
 */
record Result(HandIn handIn, String program, String digest, List<String> problems, List<String> classes,
        List<Item> items) {
    static final String FILE = "grade.json";

    /**
     * A hand-in.
     *
     * @param student the student's id
     * @param name    the name of the folder or zip; empty if nothing was handed in
     * @param date    the latest date of a file in it
     */
    record HandIn(String student, String name, Instant date) {
    }

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

    String student() {
        return handIn.student;
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

    /** @return the points in words; where none are given, as before a deadline, how much was handed in */
    String summary() {
        return most() > 0 ? ClassTables.number(points()) + " of " + ClassTables.number(most()) + " points"
                : items.stream().filter(Item::answered).count() + " of " + items.size()
                + " handed in, and no points yet";
    }

    boolean isDecided() {
        return items.stream().noneMatch(item -> item.status == Status.ERROR);
    }

    /** @return the contents of the file */
    String json() {
        return JsonText.of(Ordered.map("version", 1, "status", status().word(), "max_score", most(),
                "tests", items.stream().map(item -> Ordered.map("name", item.name, "status", item.status.word(),
                "score", item.points(), "max_score", item.weight, "answered", item.answered, "message",
                item.lines.isEmpty() ? "" : item.lines.get(0), "more", item.lines.stream().skip(1).toList(),
                "line_no", 0)).toList(), "student", student(), "handedIn", handIn.name, "date", handIn.date.toString(),
                "digest", digest, "program", program, "problems", problems, "classes", classes));
    }

    /**
     * @param file a file with a result
     * @return the result
     * @throws InvalidInputException if it is none
     */
    static Result read(Path file) {
        try {
            Map<?, ?> all = (Map<?, ?>) JsonText.read(Files.readString(file));
            return new Result(new HandIn(text(all, "student"), text(all, "handedIn"), Instant.parse(text(all, "date"))),
                    text(all, "program"), text(all, "digest"), texts(all, "problems"), texts(all, "classes"),
                    ((List<?>) all.get("tests")).stream().map(test -> item((Map<?, ?>) test)).toList());
        } catch (IOException | RuntimeException e) {
            throw new InvalidInputException(file + ": this is not a result of grade, or it is damaged");
        }
    }

    private static Item item(Map<?, ?> test) {
        List<String> lines = new ArrayList<>(texts(test, "more"));
        if (!text(test, "message").isEmpty()) {
            lines.add(0, text(test, "message"));
        }
        return new Item(text(test, "name"), (Boolean) test.get("answered"), Status.valueOf(text(test, "status")
                .toUpperCase(Locale.ROOT)), ((Number) test.get("max_score")).doubleValue(), lines);
    }

    private static String text(Map<?, ?> map, String key) {
        return map.get(key).toString();
    }

    private static List<String> texts(Map<?, ?> map, String key) {
        return ((List<?>) map.get(key)).stream().map(Object::toString).toList();
    }
}
