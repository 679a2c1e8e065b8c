package particles.app.course;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Function;
import particles.spec.messages.InvalidInputException;
import picocli.CommandLine.Option;

/** The options that say what counts, and where the numbers come from. */
final class CourseOptions {
    @Option(names = "--assignment", paramLabel = "FILE",
            description = "What counts, and how much (default: assignment.yaml, if it is there).")
    private Optional<Path> assignment;

    @Option(names = "--key", paramLabel = "FILE",
            description = "The file of the secret from which the numbers of the students' handouts come.")
    private Optional<Path> key;

    /** @return what counts */
    Assignment readAssignment() {
        return Assignment.read(assignment);
    }

    /** @return the key file */
    Optional<Path> getKey() {
        return key;
    }

    /**
     * @return for a student's id, the text from which the numbers of the exercises come; none if they are those of the
     *         handouts and there is no key
     */
    Function<String, Optional<String>> numbersOf(Assignment what) {
        Optional<String> secret = key.map(CourseOptions::secret).or(() -> Optional.of("").filter(none ->
                what.numbers() == Assignment.Numbers.ID));
        return student -> secret.map(text -> text + student.strip());
    }

    private static String secret(Path file) {
        try {
            String text = Files.readString(file).strip();
            if (!text.matches("[0-9a-f]{64}")) {
                throw new IOException("it holds no secret; gradle sheets makes a key file");
            }
            return text;
        } catch (IOException e) {
            throw new InvalidInputException(file + " cannot be read as a key file: " + e.getMessage());
        }
    }
}
