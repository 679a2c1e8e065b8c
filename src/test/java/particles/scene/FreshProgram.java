package particles.scene;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.lang.reflect.InvocationTargetException;
import java.net.MalformedURLException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.snakeyaml.engine.v2.api.Load;

/** Loads the program again with a class loader that records loaded classes, and runs a scene as if just started. */
final class FreshProgram extends URLClassLoader {
    private final Set<String> loaded = new TreeSet<>();

    /** @param first where classes are searched first */
    FreshProgram(Path... first) throws MalformedURLException {
        super(urls(first), ClassLoader.getPlatformClassLoader());
    }

    private static URL[] urls(Path... first) throws MalformedURLException {
        Set<URL> urls = new LinkedHashSet<>();
        for (Path path : first) {
            urls.add(path.toUri().toURL());
        }
        for (Class<?> known : new Class<?>[] {SceneReader.class, Load.class}) {
            urls.add(known.getProtectionDomain().getCodeSource().getLocation());
        }
        for (String entry : System.getProperty("java.class.path").split(System.getProperty("path.separator"))) {
            urls.add(Path.of(entry).toUri().toURL());
        }
        return urls.toArray(new URL[0]);
    }

    @Override
    protected Class<?> findClass(String name) throws ClassNotFoundException {
        Class<?> found = super.findClass(name);
        loaded.add(name);
        return found;
    }

    /** Reads, builds and runs a scene; returns the state at its end. */
    double[] run(String scene) throws ReflectiveOperationException {
        try {
            Object system = buildAndRun(read(scene));
            return (double[]) system.getClass().getMethod("getOwnState").invoke(system);
        } catch (InvocationTargetException e) {
            throw new AssertionError(e.getCause());
        }
    }

    /**
     * The memory that building and running a scene takes once its classes are loaded (bytes). Later on the compiler may
     * spare some of it.
     */
    long allocated(String scene) throws ReflectiveOperationException {
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        Object description = read(scene);
        long least = Long.MAX_VALUE;
        for (int run = 0; run < 4; run++) {
            long before = threads.getCurrentThreadAllocatedBytes();
            buildAndRun(description);
            least = Math.min(least, threads.getCurrentThreadAllocatedBytes() - before);
        }
        return least;
    }

    private Object read(String scene) throws ReflectiveOperationException {
        return loadClass("particles.scene.SceneReader").getMethod("read", String.class, byte[].class)
                .invoke(null, "x.yaml", scene.getBytes(StandardCharsets.UTF_8));
    }

    private Object buildAndRun(Object description) throws ReflectiveOperationException {
        Object built = loadClass("particles.scene.SceneBuilder")
                .getMethod("build", loadClass("particles.scene.format.SceneDescription"))
                .invoke(null, description);
        Object simulation = built.getClass().getMethod("simulation").invoke(built);
        simulation.getClass().getMethod("run").invoke(simulation);
        return built.getClass().getMethod("system").invoke(built);
    }

    /** The names of all loaded classes whose names begin with this. */
    Set<String> loadedFrom(String beginning) {
        return loaded.stream().filter(name -> name.startsWith(beginning))
                .collect(Collectors.toCollection(TreeSet::new));
    }

    /** The names of all laws that were loaded: effects, reactions and rules, without the packages. */
    Set<String> loadedLaws() throws ClassNotFoundException {
        Set<String> laws = new TreeSet<>();
        for (String name : Set.copyOf(loaded)) {
            Class<?> type = loadClass(name);
            for (String law : new String[] {"law.Effect", "law.Reaction", "Rule"}) {
                if (loadClass("particles." + law).isAssignableFrom(type) && !type.isInterface()
                        && !name.startsWith("particles.engine.")) {          // the engine's own passes are no laws
                    laws.add(type.getSimpleName());
                }
            }
        }
        return laws;
    }
}
