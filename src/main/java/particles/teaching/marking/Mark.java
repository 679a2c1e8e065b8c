package particles.teaching.marking;

import java.util.List;

/**
 * The mark of an answer.
 *
 * @param right whether it is right
 * @param lines the comments: the likely mistake, or the conditions that hold and that do not
 */
public record Mark(boolean right, List<String> lines) {

    private static final int MOST = 60;
    private static final int LONGEST = 1000;

    /** Copies the list, cut short and with control characters made visible: lines hold what a student's class said. */
    public Mark {
        lines = lines.stream().limit(MOST).map(line -> line.substring(0, Math.min(LONGEST, line.length()))
                .replaceAll("[\\p{Cc}\\p{Cf}\\p{Cs}]", "\ufffd")).toList();
    }

    /** @return an answer that is not right, for this reason */
    public static Mark wrong(String line) {
        return new Mark(false, List.of(line));
    }
}
