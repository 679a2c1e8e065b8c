package particles.app.course;

import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import particles.teaching.exercises.Exercises;
import picocli.CommandLine.Option;

/** The options that say what counts, and where the numbers come from. */
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
        return key != null ? CourseList.key(key).getOrDefault(student.strip(), List.of()) : what.sheets() ? List.of()
                : Collections.nCopies(Exercises.all().size() + 1, student);
    }
}
