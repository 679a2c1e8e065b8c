package particles.teaching.marking;

import java.util.List;

/**
 * The mark of an answer.
 *
 * @param right whether it is right
 * @param lines the comments: the likely mistake, or the conditions that hold and that do not
 */
public record Mark(boolean right, List<String> lines) {

    /** Copies the list. */
    public Mark {
        lines = List.copyOf(lines);
    }

    /** @return an answer that is not right, for this reason */
    public static Mark wrong(String line) {
        return new Mark(false, List.of(line));
    }
}
