package particles.spec.messages;

import java.util.List;

/** Thrown for mistakes in a scene, an option or another input; has one line for each, ready to be shown. */
public final class InvalidInputException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    private final transient List<String> lines;

    /** @param lines the mistakes, each line clear on its own */
    public InvalidInputException(List<String> lines) {
        super(String.join("\n", lines));
        this.lines = List.copyOf(lines);
    }

    /** @param line the one mistake */
    public InvalidInputException(String line) {
        this(List.of(line));
    }

    /** @return the mistakes, line by line */
    public List<String> getLines() {
        return lines;
    }
}
