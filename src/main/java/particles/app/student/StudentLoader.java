package particles.app.student;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.net.URI;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Supplier;
import javax.tools.FileObject;
import javax.tools.ForwardingJavaFileManager;
import javax.tools.JavaFileManager;
import javax.tools.JavaFileObject;
import javax.tools.SimpleJavaFileObject;
import javax.tools.StandardLocation;
import particles.app.student.Javac.Source;
import particles.spec.SourceText;

/**
 * Class loader that compiles students' classes in memory on demand, each by itself, so that a class that does not
 * compile affects only its users.
 */
public final class StudentLoader extends ClassLoader {
    /** The system property that passes the folder to a child process. */
    public static final String FOLDER = "desolver.exercises";
    private static final String PACKAGE = "exercises";
    private static final String JAVA = ".java";
    private static final int LARGEST = 1 << 20;
    private static final String OWN_CLASSES = Path.of(URI.create(StudentLoader.class.getProtectionDomain()
            .getCodeSource().getLocation().toString())).toString();

    private final Supplier<Map<String, String>> sources;
    private final Map<String, ByteArrayOutputStream> compiled = new HashMap<>();

    /** @param folder the folder of the classes of the package exercises */
    public StudentLoader(Path folder) {
        this(() -> sources(folder));
    }

    /** @param sources the text of each class, by the simple name of the class */
    StudentLoader(Supplier<Map<String, String>> sources) {
        super(StudentLoader.class.getClassLoader());
        this.sources = sources;
    }

    /** @return the text of each class of this thread's loader */
    static Map<String, String> installed() {
        return Thread.currentThread().getContextClassLoader() instanceof StudentLoader loader ? loader.sources.get()
                : Map.of();
    }

    /** @return the text of each class of this thread's loader, if a text names one of them */
    public static Map<String, String> namedIn(String text) {
        return text.contains(PACKAGE + ".") ? installed() : Map.of();
    }

    /**
     * @return the text of each class in this folder; links are not followed, so that they show no other file, and a
     *         name that is no class's, as one with letters that the locale lacks, is left out
     */
    public static Map<String, String> sources(Path folder) {
        Map<String, String> sources = new TreeMap<>();
        if (!Files.isDirectory(folder)) {
            return sources;
        }
        try (DirectoryStream<Path> files = Files.newDirectoryStream(folder, "*" + JAVA)) {
            for (Path file : files) {
                String name = file.getFileName().toString().replace(JAVA, "");
                if (name.chars().allMatch(Character::isJavaIdentifierPart) && Files.isRegularFile(file,
                        LinkOption.NOFOLLOW_LINKS) && Files.size(file) <= LARGEST) {
                    sources.put(name, SourceText.lenient(Files.readAllBytes(file)));
                }
            }
            return sources;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Makes this loader the context loader of this thread and the threads it starts. */
    public void install() {
        Thread.currentThread().setContextClassLoader(this);
    }

    /**
     * {@inheritDoc}
     *
     * @throws IllegalArgumentException if the class does not compile, or is not the one that the file's name says
     */
    @Override
    protected Class<?> findClass(String name) throws ClassNotFoundException {
        String source = name.replaceFirst("^" + PACKAGE + "[.]", "").replaceFirst("[$].*", "");
        if (!name.startsWith(PACKAGE + ".") || !compiled.containsKey(name) && !sources.get().containsKey(source)) {
            throw new ClassNotFoundException(name);
        }
        if (!compiled.containsKey(name)) {
            compile(source, sources.get());
        }
        if (!compiled.containsKey(name)) {
            if (name.contains("$")) {
                throw new ClassNotFoundException(name);
            }
            throw new IllegalArgumentException(source + JAVA + ": it has to begin with 'package exercises;', and its"
                    + " class has to be called " + source + ", as the file is");
        }
        byte[] bytes = compiled.get(name).toByteArray();
        return defineClass(name, bytes, 0, bytes.length);
    }

    /** Compiles a class, first without the libraries: opening their files takes a third of the compiler's time. */
    private void compile(String name, Map<String, String> all) {
        try {
            Javac.compile(List.of(source(name, all)), files -> new InMemory(files, all), "-cp", OWN_CLASSES);
        } catch (IllegalArgumentException e) {
            Javac.compile(List.of(source(name, all)), files -> new InMemory(files, all));
        }
    }

    private static Source source(String name, Map<String, String> all) {
        return new Source(Path.of(PACKAGE, name + JAVA), all.get(name));
    }

    /** Shows the compiler all students' sources, of which it compiles those that are used; keeps classes in memory. */
    private final class InMemory extends ForwardingJavaFileManager<JavaFileManager> {
        private final Map<String, String> all;

        InMemory(JavaFileManager files, Map<String, String> all) {
            super(files);
            this.all = all;
        }

        @Override
        public Iterable<JavaFileObject> list(JavaFileManager.Location location, String packageName,
                Set<JavaFileObject.Kind> kinds, boolean recurse) throws IOException {
            return location == StandardLocation.CLASS_PATH && packageName.equals(PACKAGE)
                    ? all.keySet().stream().<JavaFileObject>map(name -> source(name, all)).toList()
                    : super.list(location, packageName, kinds, recurse);
        }

        @Override
        public String inferBinaryName(JavaFileManager.Location location, JavaFileObject file) {
            return file instanceof Source ? file.getName().replaceFirst(".*/", PACKAGE + ".").replace(JAVA, "")
                    : super.inferBinaryName(location, file);
        }

        @Override
        public JavaFileObject getJavaFileForOutput(JavaFileManager.Location location, String name,
                JavaFileObject.Kind kind, FileObject sibling) {
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
