package particles.app.course;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
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

    boolean hasKey() {
        return key != null;                             // null where it was not given
    }

    /** @return the text from which a student's numbers come, if it is known */
    Optional<String> numbers(Assignment what, String student) {
        if (!hasKey()) {
            return what.sheets() ? Optional.empty() : Optional.of(student);
        }
        return Optional.ofNullable(CourseList.read(key).get(student.strip())).filter(cells -> cells.size() > 1)
                .map(cells -> cells.get(1));            // null where the student is not in it
    }
}
