package architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.net.MalformedURLException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import particles.app.Main;

/**
 * Whichever class is loaded first, all constants are there. Where the initialisers of two classes need each other, the
 * second finds the first's constants still null, and it depends on the order whether that does harm.
 */
class StaticInitialisersTest {
    /** Loads the project's classes anew, and knows them. */
    private static final class Fresh extends URLClassLoader {
        private final List<Class<?>> ours = new ArrayList<>();

        Fresh(URL[] path) {
            super(path, ClassLoader.getPlatformClassLoader());
        }

        @Override
        protected Class<?> findClass(String name) throws ClassNotFoundException {
            Class<?> found = super.findClass(name);
            if (name.startsWith("particles.") || name.startsWith("deSolvers.")) {
                ours.add(found);
            }
            return found;
        }
    }

    @Test
    void eachClassMayBeLoadedFirst() throws Exception {
        Path classes = Path.of(Main.class.getProtectionDomain().getCodeSource().getLocation().toURI());
        URL[] path = Arrays.stream(System.getProperty("java.class.path").split(System.getProperty("path.separator")))
                .map(StaticInitialisersTest::url).toArray(URL[]::new);
        List<String> wrong = new ArrayList<>();
        List<String> names = names(classes);
        assertTrue(names.size() > 500, names.size() + " classes");
        for (String name : names) {
            try (Fresh loader = new Fresh(path)) {
                Class.forName(name, true, loader);
                for (Class<?> loaded : List.copyOf(loader.ours)) {
                    findNull(loaded).forEach(field -> wrong.add("first " + name + ": " + field));
                }
            }
        }
        assertEquals(List.of(), wrong);
    }

    private static URL url(String entry) {
        try {
            return Path.of(entry).toUri().toURL();
        } catch (MalformedURLException e) {
            throw new IllegalStateException(e);
        }
    }

    private static List<String> names(Path classes) throws IOException {
        try (Stream<Path> files = Files.walk(classes)) {
            return files.map(classes::relativize).map(Path::toString).filter(name -> name.endsWith(".class")
                    && !name.contains("package-info")).map(name -> name.replace(".class", "")
                    .replace(classes.getFileSystem().getSeparator(), ".")).sorted().toList();
        }
    }

    private static List<String> findNull(Class<?> type) throws IllegalAccessException {
        List<String> found = new ArrayList<>();
        for (Field field : type.getDeclaredFields()) {
            if (Modifier.isStatic(field.getModifiers()) && Modifier.isFinal(field.getModifiers())
                    && !field.getType().isPrimitive()) {
                field.setAccessible(true);
                Object value = field.get(null);         // initialises the class, if it was only linked
                boolean holed = value == null || value instanceof Object[] array && Arrays.asList(array).contains(null)
                        || value instanceof Collection<?> all && all.stream().anyMatch(element -> element == null);
                if (holed) {
                    found.add(field.toString());
                }
            }
        }
        return found;
    }
}
