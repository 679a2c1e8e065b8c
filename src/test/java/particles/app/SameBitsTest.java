package particles.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import particles.scene.SceneFiles;

/**
 * A scene has one trajectory: the same bytes in every run, with and without pictures, with optimising compilers and
 * without, with one thread and with two, on the JDK of this test and on the newest one that is found beside it or named
 * by JAVA_HOME_... in the environment, as continuous integration does, or by the system property desolver.jdk (Gradle's
 * in {@code gradle hardTests -Pjdk=FOLDER}).
 */
@Tag("slow")
class SameBitsTest {
    private static final Pattern VERSION = Pattern.compile("JAVA_VERSION=\"(\\d+)[^\"]*\"");
    private static final int OLDEST = 17;
    private static final Path SCENES = Path.of("scenes");
    /** Pictures are drawn, but none is looked at. */
    private static final String SMALL = "--size=64x48";
    private static final String LARGE = """
            title: A large cloth
            teaches: threads
            solver: rk4
            deltaT: 0.002
            duration: 0.2
            shapes:
              - cloth: {corner: [-1, 0, -1], across: [2, 0, 0], down: [0, 0, 2], columns: 64, rows: 64, totalMass: 0.6,
                        fixed: [top-left], structural: {stiffness: 9, damping: 0.01}, shear: {stiffness: 3},
                              bend: {stiffness: 1}}
            effects:
              - gravity
              - drag: {coefficient: 2e-4}
              - wind: {mean: [3, 0, 1]}
              - particles.app.ThreadWitness
            output: {frameRate: 50, trajectoryStride: 10}
            """;

    @TempDir
    Path top;

    /** The JDKs found, by version, from 17 on. */
    private static TreeMap<Integer, Path> jdks() throws IOException {
        List<Path> candidates = new ArrayList<>();
        Path own = Path.of(System.getProperty("java.home"));
        try (Stream<Path> beside = Files.list(own.toAbsolutePath().getParent())) {
            beside.forEach(candidates::add);
        }
        System.getenv().forEach((name, value) -> {
            if (name.startsWith("JAVA_HOME")) {
                candidates.add(Path.of(value));
            }
        });
        String named = System.getProperty("desolver.jdk", "");
        if (!named.isEmpty()) {
            candidates.add(Path.of(named));
            assertTrue(version(Path.of(named)) >= OLDEST, named + " is no JDK from " + OLDEST + " on");
        }
        candidates.add(own);
        TreeMap<Integer, Path> jdks = new TreeMap<>();
        for (Path candidate : candidates) {
            jdks.put(version(candidate), candidate);
        }
        jdks.headMap(OLDEST).clear();
        return jdks;
    }

    /** The version of a JDK; 0 for a folder without one. */
    private static int version(Path jdk) throws IOException {
        Path release = jdk.resolve("release");
        if (!Files.isRegularFile(release) || !Files.exists(jdk.resolve("bin/java"))) {
            return 0;
        }
        Matcher matcher = VERSION.matcher(Files.readString(release));
        return matcher.find() ? Integer.parseInt(matcher.group(1)) : 0;
    }

    /** One of the runs to compare: its Java, Java's options, and those of {@link SceneSums}. */
    private record Run(Path jdk, List<String> jvm, Path scenes, List<String> options) {
        Run(Path jdk, Path scenes, String... options) {
            this(jdk, List.of(), scenes, List.of(options));
        }

        Run withOneCompiler() {
            return new Run(jdk, List.of("-XX:TieredStopAtLevel=1"), scenes, options);
        }
    }

    private Map<String, String> sums(Run run) throws IOException, InterruptedException {
        Path folder = Files.createTempDirectory(top, "run");
        List<String> command = new ArrayList<>(List.of(run.jdk.resolve("bin/java").toString(),
                "-Djava.awt.headless=true",
                "-Xmx1g"));
        command.addAll(run.jvm);
        command.addAll(List.of("-cp", System.getProperty("java.class.path"), "particles.app.SceneSums",
                run.scenes.toString(), folder.resolve("out").toString()));
        command.addAll(run.options);
        Path lines = folder.resolve("lines.txt");
        Process process = new ProcessBuilder(command).redirectErrorStream(true).redirectOutput(lines.toFile()).start();
        assertEquals(0, process.waitFor(), Files.readString(lines));
        return new TreeMap<>(Files.readAllLines(lines).stream().map(line -> line.split(" ", 2))
                .collect(Collectors.toMap(parts -> parts[0], parts -> parts[1])));
    }

    /** Makes the runs, two at a time, and compares them; a witness may only have spoken with two threads. */
    private Map<String, String> allTheSame(List<Run> runs, boolean witness) throws Exception {
        ExecutorService two = Executors.newFixedThreadPool(2);
        try {
            List<Callable<Map<String, String>>> tasks = new ArrayList<>();
            for (Run run : runs) {
                tasks.add(() -> sums(run));
            }
            List<Future<Map<String, String>>> results = two.invokeAll(tasks);
            Map<String, String> expected = null;
            for (int i = 0; i < runs.size(); i++) {
                Map<String, String> sums = results.get(i).get();
                assertEquals(witness && runs.get(i).options.contains("--threads=2"),
                        sums.remove(ThreadWitness.HELPED) != null, runs.get(i).toString());
                expected = i == 0 ? sums : expected;
                assertEquals(expected, sums, runs.get(i).toString());
            }
            return expected;
        } finally {
            two.shutdownNow();
        }
    }

    @Test
    void everySceneHasOneTrajectory() throws Exception {
        TreeMap<Integer, Path> jdks = jdks();
        System.out.println("SameBitsTest: " + jdks);
        Path own = Path.of(System.getProperty("java.home"));
        Path newest = jdks.lastEntry().getValue();
        Map<String, String> sums = allTheSame(List.of(
                new Run(own, SCENES, "--frames=true", SMALL, "--threads=2"),
                new Run(newest, SCENES, "--frames=false"),
                new Run(newest, SCENES, "--frames=false", "--threads=1").withOneCompiler()), false);
        assertEquals(SceneFiles.list(SCENES).size(), sums.size(), sums.toString());
        sums.forEach((scene, sum) -> assertTrue(sum.matches("[0-9a-f]{64}"), scene + ": " + sum));
        assertEquals(sums.size(), sums.values().stream().distinct().count(), "no two scenes are the same");
    }

    /** One that is large enough for two threads to share the work. */
    @Test
    void aLargeSceneHasOneTrajectoryWithOneThreadAndWithTwo() throws Exception {
        Path own = Path.of(System.getProperty("java.home"));
        Path newest = jdks().lastEntry().getValue();
        Path folder = Files.createDirectory(top.resolve("large"));
        Files.writeString(folder.resolve("large.yaml"), LARGE);
        Map<String, String> sums = allTheSame(List.of(
                new Run(own, folder, "--frames=false", "--threads=1"),
                new Run(own, folder, "--frames=true", SMALL, "--threads=2"),
                new Run(newest, folder, "--frames=false", "--threads=2")), true);
        assertTrue(sums.get("large.yaml").matches("[0-9a-f]{64}"), sums.toString());
    }
}
