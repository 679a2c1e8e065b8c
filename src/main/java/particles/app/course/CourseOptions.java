package particles.app.course;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Stream;
import particles.spec.messages.InvalidInputException;
import particles.teaching.exercises.Exercises;
import picocli.CommandLine.Option;

/** The options that say what counts, and where the numbers come from; reads the lists of students and keys. */
final class CourseOptions {
    @Option(names = "--assignment", paramLabel = "FILE",
            description = "What counts, and how much (default: assignment.yaml, if it is there).")
    private Path assignment;

    @Option(names = "--key", paramLabel = "FILE", description = "The key file of the students' handouts.")
    private Path key;

    /** @return what counts */
    Assignment assignment() {
        return Assignment.read(Optional.ofNullable(assignment));        // null where it was not given
    }

    /** @return the key file */
    Optional<Path> key() {
        return Optional.ofNullable(key);                // null where it was not given
    }

    /** @return the text from which a student's numbers in each exercise come, from place 1 on; empty if not known */
    List<String> numbers(Assignment what, String student) {
        return key != null ? key(key).getOrDefault(student.strip(), List.of()) : what.sheets() ? List.of()
                : Collections.nCopies(Exercises.ALL.size() + 1, student);
    }

    /**
     * Reads a CSV file with a header and a line for each student, with commas or semicolons; the id comes first.
     *
     * @param file a file such as a list of students with the names used in their hand-ins, or a key file
     * @return the cells of each line, by the id
     * @throws InvalidInputException if it cannot be read
     */
    static Map<String, List<String>> read(Path file) {
        Map<String, List<String>> lines = new TreeMap<>(String.CASE_INSENSITIVE_ORDER);
        try {
            for (String line : Files.readString(file).replaceFirst("^\ufeff", "").lines().skip(1).toList()) {
                List<String> cells = Stream.of(line.split("[,;]", -1)).map(cell -> cell.strip()
                        .replaceAll("^\"|\"$", "")).toList();
                lines.put(cells.get(0), cells);
            }
        } catch (IOException e) {
            throw new InvalidInputException(file + ": there is no such file, or it is not in UTF-8");
        }
        lines.remove("");
        return lines;
    }

    /** @return of a key file, what {@link #read} says, once each student has a secret for each exercise */
    static Map<String, List<String>> key(Path file) {
        Map<String, List<String>> keys = read(file);
        keys.forEach((student, cells) -> {
            if (cells.size() != Exercises.ALL.size() + 1) {
                throw new InvalidInputException(file + ": the line of " + student + " has " + cells.size()
                        + " cells; a key file has " + (Exercises.ALL.size() + 1));
            }
        });
        return keys;
    }
}
