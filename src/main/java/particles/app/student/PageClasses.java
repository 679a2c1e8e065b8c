package particles.app.student;

import java.io.IOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.Collections;
import java.util.Enumeration;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import particles.app.student.Javac.Source;

/** Compiles the students' classes of the lab's page, and the list of them. */
public final class PageClasses {
    private PageClasses() {
    }

    /**
     * @param solvers   the full names of students' solvers
     * @param effects   the full names of students' effects
     * @param exercises the folder of students' classes
     * @param folder    receives the compiled classes
     * @return finds the classes of the page; the students' list takes the place of the empty one
     * @throws IllegalArgumentException if a class does not compile
     * @throws IOException              if a file cannot be read or written
     */
    public static ClassLoader compile(Collection<String> solvers, Collection<String> effects, Path exercises,
            Path folder) throws IOException {
        Path sources = folder.resolve("sources");
        Path list = sources.resolve("particles/lab/browser/Students.java");
        Path copies = Files.createDirectories(sources.resolve("exercises"));
        for (Map.Entry<String, String> own : StudentLoader.sources(exercises).entrySet()) {
            Files.writeString(copies.resolve(own.getKey() + ".java"), own.getValue());
        }
        Path classes = Files.createDirectories(folder.resolve("classes"));
        Javac.compile(List.of(new Source(list, list(solvers, effects))), files -> files, "-sourcepath",
                sources.toString(), "-d", classes.toString());
        return new URLClassLoader(new URL[] {classes.toUri().toURL()}, PageClasses.class.getClassLoader()) {
            @Override
            public Enumeration<URL> getResources(String name) throws IOException {      // the page's compiler asks this
                URL own = findResource(name);
                return own == null ? super.getResources(name) : Collections.enumeration(List.of(own));
            }
        };
    }

    private static String list(Collection<String> solvers, Collection<String> effects) {
        return """
                package particles.lab.browser;

                import java.util.Map;
                import java.util.function.Supplier;

                final class Students {
                    static final Map<String, Supplier<deSolvers.DESolver>> SOLVERS = Map.ofEntries(%s);
                    static final Map<String, Supplier<particles.effects.EffectKind>> EFFECTS = Map.ofEntries(%s);
                }
                """.formatted(entries(solvers, ""), entries(effects, ".Keys"));
    }

    private static String entries(Collection<String> names, String inner) {
        return names.stream().map(name -> "Map.entry(\"%1$s\", %1$s%2$s::new)".formatted(name, inner))
                .collect(Collectors.joining(", "));
    }
}
