package particles.lab.compile;

import java.io.IOException;
import java.net.MalformedURLException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.Enumeration;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import particles.javac.Javac;
import particles.javac.Source;
import particles.lab.LabBuilder.Contents;

/** Compiles students' classes, and the list of them that the page has. */
final class StudentCompiler {
    private static final String LIST = "particles/lab/browser/Students";

    private StudentCompiler() {
    }

    /**
     * @param contents names the classes
     * @param folder   receives the compiled classes
     * @return finds the classes of the page; the students' list takes the place of the empty one
     * @throws IllegalArgumentException if a class does not compile
     */
    static ClassLoader compile(Contents contents, Path folder) throws IOException {
        Path sources = folder.resolve("sources");
        Path list = sources.resolve(LIST + ".java");
        Path exercises = Files.createDirectories(sources.resolve("exercises"));
        if (Files.isDirectory(contents.exercises())) {
            try (Stream<Path> files = Files.list(contents.exercises())) {
                for (Path file : files.filter(file -> file.toString().endsWith(".java")).toList()) {
                    Files.copy(file, exercises.resolve(file.getFileName()));
                }
            }
        }
        Path classes = Files.createDirectories(folder.resolve("classes"));
        Javac.compile(List.of(new Source(list, list(contents))), files -> files, "-sourcepath", sources.toString(),
                "-d", classes.toString());
        return new OwnFirst(classes);
    }

    private static String list(Contents contents) {
        return """
                package particles.lab.browser;

                final class Students {
                    static final java.util.Map<String, java.util.function.Supplier<deSolvers.DESolver>> SOLVERS
                            = java.util.Map.ofEntries(%s);
                    static final java.util.Map<String,
                            java.util.function.Supplier<particles.effects.EffectKind>> EFFECTS
                            = java.util.Map.ofEntries(%s);
                }
                """.formatted(entries(contents.solvers(), ""), entries(contents.effects(), ".Keys"));
    }

    private static String entries(List<String> names, String inner) {
        return names.stream().map(name -> "java.util.Map.entry(\"" + name + "\", " + name + inner + "::new)")
                .collect(Collectors.joining(", "));
    }

    /** Class loader that prefers the classes just compiled. */
    private static final class OwnFirst extends URLClassLoader {
        OwnFirst(Path classes) throws MalformedURLException {
            super(new URL[] {classes.toUri().toURL()}, OwnFirst.class.getClassLoader());
        }

        @Override
        public URL getResource(String name) {
            URL own = findResource(name);
            return own == null ? super.getResource(name) : own;
        }

        @Override
        public Enumeration<URL> getResources(String name) throws IOException {
            URL own = findResource(name);
            return own == null ? super.getResources(name) : Collections.enumeration(List.of(own));
        }
    }
}
