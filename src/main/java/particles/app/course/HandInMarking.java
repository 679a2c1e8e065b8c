package particles.app.course;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Supplier;
import particles.app.cli.Version;
import particles.app.course.Result.HandIn;
import particles.spec.messages.InvalidInputException;

/** Marks a hand-in in two parts: the answers at once, the classes later, when no answers are left to mark. */
final class HandInMarking {
    private HandInMarking() {
    }

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
        Map<String, String> files = new TreeMap<>();
        handIn.files().forEach((name, bytes) -> files.put(name, Marking.digest(new String(bytes,
                StandardCharsets.ISO_8859_1))));
        String digest = Marking.digest(Version.CURRENT + '\0' + assignment + '\0' + numbers + files);
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
}
