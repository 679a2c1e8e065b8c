package particles.scene;

import java.util.List;

/** A scene that cannot be: everything that is wrong with it, one line each, to be shown as it is. */
public class SceneException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    private final transient List<String> lines;

    /** @param lines what is wrong, each with its place; at least one */
    public SceneException(List<String> lines) {
        super(String.join(System.lineSeparator(), lines));
        this.lines = List.copyOf(lines);
    }

    /** @return what is wrong, each with its place */
    public List<String> getLines() {
        return lines;
    }
}
