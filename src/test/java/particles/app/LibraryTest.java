package particles.app;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import particles.app.cli.Program;

/** README's programs compile and run with the project's jar, as in somebody else's project. */
class LibraryTest {
    private static final String JAR = "build/libs/desolver-" + Program.VERSION + ".jar";
    private static final List<String> EXAMPLES = Pattern.compile("(?s)```java\n(.*?)```").matcher(ReadmeTest.README)
            .results().map(block -> block.group(1)).toList();

    @TempDir
    Path folder;

    private List<String> run(String path, String name, String program) throws IOException, InterruptedException {
        Path file = Files.writeString(folder.resolve(name), program);
        ChildProgram child = new ChildProgram(folder.resolve("lines.txt"));
        ChildProgram.End end = child.end(child.startJava("-cp", path, file.toString()));
        assertEquals(0, end.code(), end.lines());
        return end.lines().lines().toList();
    }

    /** Solvers need no other library. A step of RK4 multiplies the distance from 20 degrees by 1 - z + ... + z^4/24. */
    @Test
    void anOwnSourceIsSteppedWithTheJarAlone() throws IOException, InterruptedException {
        double z = 0.05;
        double factor = 1 - z + z * z / 2 - z * z * z / 6 + z * z * z * z / 24;
        List<String> lines = run(JAR, "Tea.java", EXAMPLES.get(0));
        assertEquals(1, lines.size(), lines.toString());
        assertEquals(20 + 70 * factor, Double.parseDouble(lines.get(0)), 3e-14);        // measured: 1.5e-14
    }

    /** The block starts at x = 1 with Euler's step: its first step moves it with its velocity, 0. */
    @Test
    void aSceneIsRunAndItsStatesAreRead() throws IOException, InterruptedException {
        String libraries = Stream.of(System.getProperty("java.class.path").split(File.pathSeparator))
                .filter(path -> path.contains("snakeyaml") || path.contains("ejml"))
                .collect(Collectors.joining(File.pathSeparator));
        List<String> lines = run(JAR + File.pathSeparator + libraries, "Own.java", """
                import java.nio.file.Path;
                import particles.Simulation;
                import particles.scene.SceneBuilder;
                import particles.scene.SceneReader;

                class Own {
                    public static void main(String[] args) {
                %s    }
                }
                """.formatted(EXAMPLES.get(1)));
        assertEquals(161, lines.size());
        assertEquals(List.of("0.0 s: the block is at x = 1.0 m", "0.11737 s: the block is at x = 1.0 m"),
                lines.subList(0, 2));
    }
}
