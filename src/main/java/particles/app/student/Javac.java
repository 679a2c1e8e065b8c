package particles.app.student;

import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import javax.tools.Diagnostic;
import javax.tools.DiagnosticCollector;
import javax.tools.JavaCompiler;
import javax.tools.JavaFileManager;
import javax.tools.JavaFileObject;
import javax.tools.SimpleJavaFileObject;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;

/** Runs the compiler, and tells all errors, one line each. */
final class Javac {
    private static final int MOST_ERRORS = 8;

    private Javac() {
    }

    /**
     * Compiles sources.
     *
     * @param sources the sources
     * @param manager reads and writes files in place of the usual one, which it is given
     * @param more    further options
     * @throws IllegalArgumentException with the errors, if it does not compile
     */
    static void compile(List<Source> sources, UnaryOperator<JavaFileManager> manager, String... more) {
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        if (compiler == null) {                         // null on a Java that only runs programs
            throw new IllegalArgumentException("this Java has no compiler: your own classes need a JDK, not a JRE");
        }
        List<String> options = new ArrayList<>(List.of("-cp", System.getProperty("java.class.path"), "-proc:none"));
        options.addAll(List.of(more));
        DiagnosticCollector<JavaFileObject> messages = new DiagnosticCollector<>();
        try (StandardJavaFileManager files = compiler.getStandardFileManager(messages, Locale.ROOT, null);
                JavaFileManager used = manager.apply(files)) {
            if (!compiler.getTask(null, used, messages, options, null, sources).call()) {
                throw new IllegalArgumentException("it does not compile: " + messages.getDiagnostics().stream()
                        .filter(message -> message.getKind() == Diagnostic.Kind.ERROR).limit(MOST_ERRORS)
                        .map(Javac::line).collect(Collectors.joining("\n  ")));
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static String line(Diagnostic<? extends JavaFileObject> message) {
        String text = message.getMessage(Locale.ROOT).replaceAll("\\s*symbol:\\s*", ": ")
                .replaceAll("\\s*location:[^\n]*", "").replaceAll("\\s+", " ");
        return message.getSource() == null ? text       // null for an error in no file
                : new File(message.getSource().getName()).getName() + ":" + message.getLineNumber() + ": " + text;
    }

    /** The text of a class, for the compiler; the file itself is not read. */
    static final class Source extends SimpleJavaFileObject {
        private final String text;

        /**
         * @param file the file's name, for messages
         * @param text its contents
         */
        Source(Path file, String text) {
            super(file.toUri(), Kind.SOURCE);
            this.text = text;
        }

        @Override
        public CharSequence getCharContent(boolean ignoreEncodingErrors) {
            return text;
        }
    }
}
