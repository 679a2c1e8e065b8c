package benchmarks;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import javax.tools.ToolProvider;
import org.openjdk.jmh.generators.core.BenchmarkGenerator;
import org.openjdk.jmh.generators.core.FileSystemDestination;
import org.openjdk.jmh.generators.reflection.RFGeneratorSource;
import particles.output.FrameBenchmark;

/**
 * Generates and compiles the JMH harness: a class around each benchmark with its loop and clock. Usually an annotation
 * processor does this in every build; as a separate step it costs nothing in other builds.
 */
final class Harness {
    static final List<Class<?>> BENCHMARKS = List.of(SolveBenchmark.class, SceneBenchmark.class, FrameBenchmark.class);

    private Harness() {
    }

    /**
     * @param folder the output folder, which must be on the class path of the benchmarks
     * @throws IllegalStateException if a class is not a valid benchmark
     */
    static void write(Path folder) throws IOException {
        Path sources = Files.createDirectories(folder.resolve("sources"));
        RFGeneratorSource benchmarks = new RFGeneratorSource();
        benchmarks.processClasses(BENCHMARKS.toArray(Class<?>[]::new));
        FileSystemDestination written = new FileSystemDestination(folder.toFile(), sources.toFile());
        BenchmarkGenerator generator = new BenchmarkGenerator();
        generator.generate(benchmarks, written);
        generator.complete(benchmarks, written);
        if (written.hasErrors()) {
            throw new IllegalStateException(written.getErrors().toString());
        }
        List<String> arguments = new ArrayList<>(List.of("-proc:none", "-nowarn", "-d", folder.toString(), "-cp",
                System.getProperty("java.class.path")));
        try (Stream<Path> files = Files.walk(sources)) {
            files.filter(file -> file.toString().endsWith(".java")).map(Path::toString).forEach(arguments::add);
        }
        if (ToolProvider.getSystemJavaCompiler().run(null, null, null, arguments.toArray(String[]::new)) != 0) {
            throw new IllegalStateException("what JMH wrote does not compile; the lines above say why");
        }
    }

    /** @param args the folder */
    public static void main(String[] args) throws IOException {
        write(Path.of(args[0]));
    }
}
