package particles.app.student;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import javax.tools.FileObject;
import javax.tools.ForwardingJavaFileManager;
import javax.tools.JavaFileManager;
import javax.tools.JavaFileObject;
import javax.tools.SimpleJavaFileObject;
import javax.tools.StandardLocation;
import particles.javac.Javac;

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
     * @throws IllegalArgumentException if the class does not compile, or is not the one that the file's name says
     */
    @Override
    protected Class<?> findClass(String name) throws ClassNotFoundException {
        Path source = folder.resolve(name.replaceFirst("^" + PACKAGE + "[.]", "").replaceFirst("[$].*", "") + ".java");
        if (!name.startsWith(PACKAGE + ".") || !compiled.containsKey(name) && !Files.isRegularFile(source)) {
            throw new ClassNotFoundException(name);
        }
        if (!compiled.containsKey(name)) {
            Javac.compile(source, folder.toAbsolutePath().getParent(), List.of(), InMemory::new);
        }
        if (!compiled.containsKey(name)) {
            String bare = name.replace(PACKAGE + ".", "");
            if (bare.contains("$")) {
                throw new ClassNotFoundException(name);
            }
            throw new IllegalArgumentException(source.getFileName() + (compiled.containsKey(bare)
                    ? ": the first line has to be 'package exercises;'" : ": the class in it has to be called " + bare
                    + ", as the file is"));
        }
        byte[] bytes = compiled.get(name).toByteArray();
        return defineClass(name, bytes, 0, bytes.length);
    }

    /** Keeps compiled classes in memory and shows the compiler only students' sources. */
    private final class InMemory extends ForwardingJavaFileManager<JavaFileManager> {
        InMemory(JavaFileManager files) {
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
