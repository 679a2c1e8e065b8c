package particles.app.course;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import particles.spec.messages.InvalidInputException;
import particles.teaching.exercises.Exercises;

/** A CSV file with a header and a line for each student, with commas or semicolons; the id comes first. */
final class CourseList {
    private CourseList() {
    }

    /**
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
            if (cells.size() != Exercises.all().size() + 1) {
                throw new InvalidInputException(file + ": the line of " + student + " has " + cells.size()
                        + " cells; a key file has " + (Exercises.all().size() + 1));
            }
        });
        return keys;
    }
}
