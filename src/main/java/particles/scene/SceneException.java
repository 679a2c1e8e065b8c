package particles.scene;

import java.util.List;
import particles.spec.messages.Problems;

/** Thrown for a faulty scene; has one line for each problem, ready to be shown. */
public class SceneException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    private final transient List<String> lines;

    /** @param lines the problems, each with its place; at least one */
    public SceneException(List<String> lines) {
        super(String.join(System.lineSeparator(), lines));
        this.lines = List.copyOf(lines);
    }

    SceneException(String line) {
        this(List.of(line));
    }

    /** Throws an exception with these problems, if there are any. */
    static void throwIfAny(Problems problems) {
        if (problems.count() > 0) {
            throw new SceneException(problems.lines());
        }
    }

    /** @return the problems, each with its place */
    public List<String> getLines() {
        return lines;
    }
}
