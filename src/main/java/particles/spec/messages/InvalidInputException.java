package particles.spec.messages;

import java.util.List;

/** Thrown for mistakes in a scene, an option or another input; has one line for each, ready to be shown. */
public final class InvalidInputException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    /** @param lines the mistakes, each line clear on its own */
    public InvalidInputException(List<String> lines) {
        this(String.join("\n", lines));
    }

    /** @param lines the mistakes; a line feed separates two */
    public InvalidInputException(String lines) {
        super(lines);
    }

    /** @return the mistakes, line by line */
    public List<String> getLines() {
        return List.of(getMessage().split("\n"));
    }
}
