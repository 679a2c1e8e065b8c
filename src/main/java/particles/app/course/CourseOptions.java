package particles.app.course;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Function;
import particles.spec.messages.InvalidInputException;
import picocli.CommandLine.Option;

/** The options that say what counts, and where the numbers come from. */
final class CourseOptions {
    @Option(names = "--assignment", paramLabel = "FILE",
            description = "What counts, and how much (default: assignment.yaml, if it is there).")
    private Optional<Path> assignment;

    @Option(names = "--key", paramLabel = "FILE", description = "The key file of the students' handouts.")
    private Optional<Path> key;

    /** @return what counts */
    Assignment readAssignment() {
        return Assignment.read(assignment);
    }

    /** @return the key file */
    Optional<Path> getKey() {
        return key;
    }

    /** @return for a student's id, the text from which the numbers come; empty if it is not known */
    Function<String, Optional<String>> numbersOf(Assignment what) {
        Map<String, String> secrets = key.map(CourseOptions::secrets).orElse(Map.of());
        return student -> key.isEmpty() && what.numbers() == Assignment.Numbers.ID ? Optional.of(student)
                : Optional.ofNullable(secrets.get(student.strip()));
    }

    /**
     * @return the secrets in a key file, by the students' ids
     * @throws InvalidInputException if a line has another number of columns: written again, it would lose its secret
     */
    static Map<String, String> secrets(Path file) {
        Map<String, String> secrets = new TreeMap<>(String.CASE_INSENSITIVE_ORDER);
        List<List<String>> rows = ClassList.rows(file);
        rows.stream().skip(1).forEach(cells -> {
            if (cells.size() != 2) {
                throw new InvalidInputException(file + ":" + (rows.indexOf(cells) + 1)
                        + ": a key file has 2 columns, student and secret");
            }
            secrets.put(cells.get(0), cells.get(1));
        });
        return secrets;
    }
}
