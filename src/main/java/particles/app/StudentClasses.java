package particles.app;

import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import javax.tools.Diagnostic;
import javax.tools.DiagnosticCollector;
import javax.tools.JavaCompiler;
import javax.tools.JavaFileObject;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;

/** Compiles students' classes one by one, so that one which does not compile takes no other with it. */
final class StudentClasses {
    private static final String PACKAGE = "exercises";

    private final Path sources;
    private final Path classes;

    private StudentClasses(Path sources, Path classes) {
        this.sources = sources;
        this.classes = classes;
    }

    /**
     * @param folder where a student's classes are, all of the package exercises
     * @param work   a folder for what is compiled
     * @return the classes, to be compiled
     * @throws IOException if the work folder cannot be written
     */
    static StudentClasses in(Path folder, Path work) throws IOException {
        // a copy: a path to the sources where they are would let the compiler find the whole program there
        Path copies = Files.createDirectories(work.resolve("sources").resolve(PACKAGE));
        if (Files.isDirectory(folder)) {
            try (Stream<Path> files = Files.list(folder)) {
                for (Path file : files.filter(f -> f.toString().endsWith(".java")).sorted().toList()) {
                    Files.copy(file, copies.resolve(file.getFileName().toString()));
                }
            }
        }
        return new StudentClasses(copies, Files.createDirectories(work.resolve("classes")));
    }

    /** @return where compiled classes are found */
    Path path() {
        return classes;
    }

    /** @return the simple names of all classes whose name ends like this */
    List<String> named(String ending) {
        try (Stream<Path> files = Files.list(sources)) {
            return files.map(file -> file.getFileName().toString()).filter(name -> name.endsWith(ending + ".java"))
                    .map(name -> name.substring(0, name.length() - ".java".length())).sorted().toList();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /**
     * Compiles a class and what it uses of the others.
     *
     * @param name a simple name
     * @return what is wrong, in one line: the compiler's first message; nothing if it compiles
     * @throws IOException if a file cannot be read or written
     */
    Optional<String> compile(String name) throws IOException {
        Path source = sources.resolve(name + ".java");
        if (!Files.isRegularFile(source)) {
            return Optional.of("there is no file " + name + ".java");
        }
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        if (compiler == null) {                         // null on a Java that only runs programs
            throw new Failure(ExitCode.TROUBLE, "this Java has no compiler: a JDK is needed, not a JRE");
        }
        DiagnosticCollector<JavaFileObject> messages = new DiagnosticCollector<>();
        try (StandardJavaFileManager files = compiler.getStandardFileManager(messages, Locale.ROOT, null)) {
            boolean compiles = compiler.getTask(null, files, messages, List.of("-cp", System.getProperty("java.class.path"),
                    "-sourcepath",
                    sources.getParent().toString(), "-d", classes.toString(), "-proc:none", "--release", "17"), null,
                    files.getJavaFileObjects(source.toFile())).call();
            return compiles ? Optional.empty() : Optional.of(messages.getDiagnostics().stream()
                    .filter(message -> message.getKind() == Diagnostic.Kind.ERROR).findFirst().map(StudentClasses::line)
                    .orElse("it does not compile"));
        }
    }

    private static String line(Diagnostic<? extends JavaFileObject> message) {
        String text = "it does not compile: " + message.getMessage(Locale.ROOT).replaceAll("\\s+", " ");
        return message.getSource() == null ? text       // null for what is wrong with no file
                : new File(message.getSource().getName()).getName() + ":" + message.getLineNumber() + ": " + text;
    }
}
