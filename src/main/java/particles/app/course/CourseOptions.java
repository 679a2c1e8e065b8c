package particles.app.course;

import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Function;
import particles.spec.messages.InvalidInputException;
import particles.teaching.exercises.Exercises;
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

    /**
     * @return for a student's id, the text from which the numbers in each exercise come, from place 1 on; empty if not
     *         known
     */
    Function<String, List<String>> numbersOf(Assignment what) {
        Map<String, List<String>> keys = key.map(CourseOptions::key).orElse(Map.of());
        return student -> key.isPresent() ? keys.getOrDefault(student.strip(), List.of())
                : what.numbers() == Assignment.Numbers.SHEET ? List.of()
                : Collections.nCopies(Exercises.ALL.size() + 1, student);
    }

    /** @return the cells of each line of a key file, by the id; each student has a secret for each exercise */
    static Map<String, List<String>> key(Path file) {
        Map<String, List<String>> keys = new TreeMap<>(String.CASE_INSENSITIVE_ORDER);
        ClassList.rows(file).stream().skip(1).filter(cells -> cells.size() > 1).forEach(cells -> {
            if (cells.size() != Exercises.ALL.size() + 1) {
                throw new InvalidInputException(file + ": the line of " + cells.get(0) + " has " + cells.size()
                        + " cells; a key file has " + (Exercises.ALL.size() + 1));
            }
            keys.put(cells.get(0), cells);
        });
        return keys;
    }
}
