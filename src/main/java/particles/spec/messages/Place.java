package particles.spec.messages;

import java.util.Optional;
import org.snakeyaml.engine.v2.exceptions.Mark;

/**
 * A place in a source: file or option, line and column.
 *
 * @param source the file as the user named it, or an option such as {@code -PdeltaT}
 * @param line   the line, from 1; 0 if the source as a whole is meant
 * @param column the column in characters, from 1; 0 if the source as a whole is meant
 */
public record Place(String source, int line, int column) implements Comparable<Place> {

    /** @return the source as a whole */
    public static Place of(String source) {
        return new Place(source, 0, 0);
    }

    /** @return the place of a parser's mark, which names its source; the whole source without one */
    public static Place of(String source, Optional<Mark> mark) {
        return mark.map(m -> new Place(m.getName(), m.getLine() + 1, m.getColumn() + 1)).orElse(of(source));
    }

    @Override
    public int compareTo(Place other) {
        return line != other.line ? Integer.compare(line, other.line) : Integer.compare(column, other.column);
    }

    @Override
    public String toString() {
        return line == 0 ? source : source + ":" + line + ":" + column;
    }
}
