package particles.app.course;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.Callable;
import java.util.stream.Stream;
import particles.app.cli.Failure;
import particles.app.cli.Version;
import particles.app.course.Result.Item;
import particles.teaching.exercises.AnswersFile;

/** Marks a hand-in in two parts: the answers at once, the classes later, when no answers are left to mark. */
final class HandInMarking {
    private HandInMarking() {
    }

    /**
     * Marks the answers. Where the same hand-in was marked before, it takes that result.
     *
     * @param student    the id
     * @param handIn     what was handed in; empty for nothing
     * @param assignment what counts
     * @param numbers    the text from which the numbers of each exercise come; empty if that is not known
     * @param results    the folder of the result
     * @param copy       a new folder, which stays until the classes have run
     * @return what runs the classes and makes the result
     * @throws IOException if a file cannot be written
     */
    static Callable<Result> begin(String student, Optional<Submission> handIn, Assignment assignment,
            List<String> numbers, Path results, Path copy) throws IOException {
        Map<String, byte[]> files = new TreeMap<>(handIn.map(Submission::files).orElse(Map.of()));
        StringBuilder all = new StringBuilder(Version.CURRENT + '\0' + assignment.text() + '\0' + numbers);
        files.forEach((name, bytes) -> all.append('\0').append(name).append('\0').append(bytes.length).append('\0')
                .append(new String(bytes, StandardCharsets.ISO_8859_1)));
        String digest = Marking.digest(all.toString());
        Optional<Result> earlier = earlier(results.resolve(Result.FILE)).filter(result -> result.isDecided()
                && result.digest().equals(digest) && result.student().equals(student));
        if (earlier.isPresent()) {
            Result same = earlier.get();                // downloaded again, it may have another date
            return () -> new Result(student, handIn.map(Submission::name).orElse(""), handIn.map(Submission::newest)
                    .orElse(Instant.EPOCH), same.program(), digest, same.problems(), same.classes(), same.items());
        }
        Files.createDirectories(copy);
        Map<String, String> sources = handIn.map(Submission::sources).orElse(Map.of());
        Marking marking = new Marking(assignment, numbers, handIn.isPresent() ? handIn.get().copyAnswers(copy)
                : copy.resolve("answers.yaml"), sources, results);
        AnswersFile read = AnswersFile.read(marking.answers());
        List<Item> items = new ArrayList<>(marking.exercises(read));
        List<String> problems = new ArrayList<>(handIn.map(Submission::problems).orElse(List.of()));
        problems.addAll(marking.withoutFolder(read.problems()));
        return () -> {
            items.addAll(marking.classes());
            return new Result(student, handIn.map(Submission::name).orElse(""), handIn.map(Submission::newest)
                    .orElse(Instant.EPOCH), Version.CURRENT, digest, problems,
                    Copies.of(sources), items);
        };
    }

    /** The result of an earlier run; a damaged one is none. */
    private static Optional<Result> earlier(Path file) {
        try {
            return Files.isRegularFile(file) ? Optional.of(Result.read(file)) : Optional.empty();
        } catch (Failure damaged) {
            return Optional.empty();
        }
    }

    /** Deletes a folder of copies. */
    static void delete(Path folder) throws IOException {
        try (Stream<Path> made = Files.walk(folder)) {
            for (Path path : made.sorted(Comparator.reverseOrder()).toList()) {
                Files.delete(path);
            }
        }
    }
}
