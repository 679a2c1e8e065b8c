package particles.teaching.marking;

import java.util.List;

/**
 * The mark of an answer.
 *
 * @param right whether it is right
 * @param lines the comments: the likely mistake, or the conditions that hold and that do not
 */
public record Mark(boolean right, List<String> lines) {

    /** Copies the list, with control characters made visible: lines hold what a student's class said. */
    public Mark {
        lines = lines.stream().map(line -> line.replaceAll("[\\p{Cc}\\p{Cf}]", "\ufffd")).toList();
    }

    /** @return an answer that is not right, for this reason */
    public static Mark wrong(String line) {
        return new Mark(false, List.of(line));
    }
}
