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

    /** @return the simple name of the class that the file's name promises */
    public String simpleName() {
        return getName().replaceFirst(".*/", "").replace(Kind.SOURCE.extension, "");
    }

    @Override
    public CharSequence getCharContent(boolean ignoreEncodingErrors) {
        return text;
    }
}
