package particles.javac;

import java.nio.file.Path;
import javax.tools.SimpleJavaFileObject;

/** The text of a class, for the compiler; the file itself is not read. */
public final class Source extends SimpleJavaFileObject {
    private final String text;

    /**
     * @param file the file's name, for messages
     * @param text its contents
     */
    public Source(Path file, String text) {
        super(file.toUri(), Kind.SOURCE);
        this.text = text;
    }

    @Override
    public CharSequence getCharContent(boolean ignoreEncodingErrors) {
        return text;
    }
}
