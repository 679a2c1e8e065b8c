package particles.app.student;

import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import javax.tools.Diagnostic;
import javax.tools.DiagnosticCollector;
import javax.tools.FileObject;
import javax.tools.ForwardingJavaFileManager;
import javax.tools.JavaCompiler;
import javax.tools.JavaFileManager;
import javax.tools.JavaFileObject;
import javax.tools.SimpleJavaFileObject;
import javax.tools.StandardJavaFileManager;
import javax.tools.StandardLocation;
import javax.tools.ToolProvider;

/**
 * Class loader that compiles students' classes in memory on demand, each by itself, so that a class that does not
 * compile affects only its users.
 */
public final class StudentLoader extends ClassLoader {
    /** The system property that passes the folder to a child process. */
    public static final String FOLDER = "desolver.exercises";
    private static final String PACKAGE = "exercises";

    private final Path folder;
    private final Map<String, ByteArrayOutputStream> compiled = new HashMap<>();

    /**
     * @param folder the folder of the classes of the package exercises
     * @param parent the loader of all other classes
     */
    public StudentLoader(Path folder, ClassLoader parent) {
        super(parent);
        this.folder = folder;
    }

    /** Makes this loader the context loader of this thread and the threads it starts. */
    public void install() {
        Thread.currentThread().setContextClassLoader(this);
    }

    /**
     * {@inheritDoc}
     *
     * @throws IllegalArgumentException with the compiler's first message, if the class does not compile
     */
    @Override
    protected Class<?> findClass(String name) throws ClassNotFoundException {
        Path source = folder.resolve(name.replaceFirst("^" + PACKAGE + "[.]", "").replaceFirst("[$].*", "") + ".java");
        if (!name.startsWith(PACKAGE + ".") || !compiled.containsKey(name) && !Files.isRegularFile(source)) {
            throw new ClassNotFoundException(name);
        }
        if (!compiled.containsKey(name)) {
            compile(source);
        }
        if (!compiled.containsKey(name)) {
            throw new ClassNotFoundException(name);
        }
        byte[] bytes = compiled.get(name).toByteArray();
        return defineClass(name, bytes, 0, bytes.length);
    }

    private void compile(Path source) {
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        if (compiler == null) {                         // null on a Java that only runs programs
            throw new IllegalArgumentException("this Java has no compiler: your own classes need a JDK, not a JRE");
        }
        DiagnosticCollector<JavaFileObject> messages = new DiagnosticCollector<>();
        try (StandardJavaFileManager files = compiler.getStandardFileManager(messages, Locale.ROOT, null);
                InMemory memory = new InMemory(files)) {
            files.setLocation(StandardLocation.SOURCE_PATH, List.of(folder.toAbsolutePath().getParent().toFile()));
            boolean compiles = compiler.getTask(null, memory, messages,
                    List.of("-cp", System.getProperty("java.class.path"),
                    "-proc:none"),
                    null, files.getJavaFileObjects(source.toFile())).call();
            if (!compiles) {
                throw new IllegalArgumentException(messages.getDiagnostics().stream()
                        .filter(message -> message.getKind() == Diagnostic.Kind.ERROR).findFirst()
                        .map(StudentLoader::line)
                        .orElse(source.getFileName() + ": it does not compile"));
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static String line(Diagnostic<? extends JavaFileObject> message) {
        String text = "it does not compile: " + message.getMessage(Locale.ROOT).replaceAll("\\s+", " ");
        return message.getSource() == null ? text       // null for what is wrong with no file
                : new File(message.getSource().getName()).getName() + ":" + message.getLineNumber() + ": " + text;
    }

    /** Keeps compiled classes in memory and shows the compiler only students' sources. */
    private final class InMemory extends ForwardingJavaFileManager<StandardJavaFileManager> {
        InMemory(StandardJavaFileManager files) {
            super(files);
        }

        @Override
        public Iterable<JavaFileObject> list(JavaFileManager.Location location, String packageName,
                Set<JavaFileObject.Kind> kinds,
                boolean recurse) throws IOException {
            return location == StandardLocation.SOURCE_PATH && !packageName.equals(PACKAGE) ? List.of()
                    : super.list(location, packageName, kinds, recurse);
        }

        @Override
        public JavaFileObject getJavaFileForOutput(JavaFileManager.Location location, String name,
                JavaFileObject.Kind kind,
                FileObject sibling) {
            return new SimpleJavaFileObject(URI.create("memory:///" + name.replace('.', '/') + kind.extension), kind) {
                @Override
                public OutputStream openOutputStream() {
                    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
                    compiled.put(name, bytes);
                    return bytes;
                }
            };
        }
    }
}
