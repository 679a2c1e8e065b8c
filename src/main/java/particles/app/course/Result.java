package particles.app.course;

import com.google.gson.FieldNamingPolicy;
import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import com.google.gson.annotations.SerializedName;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import particles.teaching.exercises.Draw;
import particles.teaching.exercises.Exercise.Mark;

/**
 * The result of one hand-in: the file grade.json. {@code status}, {@code max_score} and {@code tests} are those that
 * the autograding reporter of GitHub Classroom reads; the other keys are ours.
 *
 * @param version  of the reporter's format
 * @param status   right if all marks are
 * @param maxScore the most points
 * @param tests    the marks
 * @param student  the student's id; of a hand-in that is nobody's, its name
 * @param state    whether it was marked
 * @param handIn   the name of the folder or archive; empty if nothing was handed in
 * @param date     the latest date of a file in it
 * @param digest   of everything on which the result depends
 * @param problems lines on what could not be read
 */
record Result(int version, Status status, double maxScore, List<Item> tests, String student, State state,
        String handIn, String date, String digest, List<String> problems) {
    static final String FILE = "grade.json";
    private static final Gson JSON = new GsonBuilder().setPrettyPrinting().disableHtmlEscaping()
            .setFieldNamingPolicy(FieldNamingPolicy.LOWER_CASE_WITH_UNDERSCORES).create();

    /** Right, wrong or missing, not decided. */
    enum Status {
        @SerializedName("pass") PASS,
        @SerializedName("fail") FAIL,
        @SerializedName("error") ERROR
    }

    /** Why there are no marks; first those that a person has to look at. */
    enum State {
        WHOSE("whose?"),
        UNREADABLE("cannot be read"),
        NOTHING("nothing handed in"),
        MARKED("");

        private final String words;

        State(String words) {
            this.words = words;
        }

        String words() {
            return words;
        }
    }

    /**
     * A mark.
     *
     * @param name     the exercise or class
     * @param status   the mark; not decided if the machine was too busy
     * @param score    the points
     * @param maxScore the most points
     * @param answered whether it was handed in
     * @param message  the comments, in lines
     * @param lineNo   always 0
     */
    record Item(String name, Status status, double score, double maxScore, boolean answered, String message,
            int lineNo) {
        static Item of(String name, boolean answered, Status status, double weight, Mark mark) {
            return new Item(name, status, status == Status.PASS ? weight : 0, weight, answered,
                    String.join("\n", mark.lines()), 0);
        }

        /** @return the first mistake */
        String mistake() {
            return status == Status.PASS ? "" : message.lines().filter(line -> line.matches("(WRONG|PROMISE), .*"))
                    .findFirst().or(() -> message.lines().findFirst()).orElse("");
        }
    }

    /** A result that was damaged lacks something. */
    Result {
        Stream.of(status, tests, student, state, handIn, date, digest, problems)
                .forEach(Objects::requireNonNull);
    }

    /** A result of this program. */
    static Result of(String student, State state, Submission handIn, String digest, List<String> problems,
            List<Item> items) {
        boolean decided = state.compareTo(State.NOTHING) >= 0 && items.stream().noneMatch(item -> item.status
                == Status.ERROR);
        return new Result(1, !decided ? Status.ERROR : items.stream().allMatch(item -> item.status == Status.PASS)
                ? Status.PASS : Status.FAIL, items.stream().mapToDouble(Item::maxScore).sum(), items, student, state,
                handIn.name(), handIn.newest(), digest, problems);
    }

    double points() {
        return tests.stream().mapToDouble(Item::score).sum();
    }

    /** @return the points in words, and whose they are */
    String summary() {
        return Draw.text(points()) + " of " + Draw.text(maxScore) + " points for " + student;
    }

    /** @return why there are no marks */
    String reason() {
        return state.words() + ": " + Stream.concat(Stream.of(student), problems.stream()).collect(Collectors.joining(
                ", "));
    }

    /** @return the contents of the file */
    String json() {
        return JSON.toJson(this) + "\n";
    }

    /** @return the result in a file; nothing if there is none, or it is damaged */
    static Optional<Result> read(Path file) {
        try {
            return Optional.ofNullable(JSON.fromJson(Files.readString(file), Result.class));
        } catch (IOException | RuntimeException e) {
            return Optional.empty();
        }
    }
}
