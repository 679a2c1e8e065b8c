package particles.app.experiments;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Texts.assertHas;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import particles.app.cli.ExitCode;
import particles.app.cli.OptionStyle;
import particles.app.cli.Screen;
import particles.app.student.StudentLoader;

/** The rows of a sweep survive a stop, and are the same in one run and in parts. */
class SweepCommandTest {
    private static final List<String> FILES = List.of("sweep.csv", "sweep.md", "max-x-of-block.csv",
            "max-x-of-block.png");
    private static final String PUSHER = """
            package exercises;

            import particles.effects.EffectContext;
            import particles.effects.EffectKind;
            import particles.law.ParticleForce;
            import particles.law.Particles;
            import particles.law.Vector3;
            import particles.spec.Values;

            public final class Pusher extends ParticleForce {
                public Pusher(Particles particles) {
                    super(particles);
                }

                @Override
                protected Vector3 getForce(Vector3 position, Vector3 velocity, double mass, double time) {
                    return new Vector3(Push.FORCE, 0, 0);
                }

                public static final class Keys extends EffectKind {
                    public Keys() {
                        super("exercises.Pusher", "A constant force.");
                    }

                    @Override
                    public void build(Values values, EffectContext scene) {
                        scene.add(new Pusher(scene.particles()));
                    }
                }
            }
            """;

    @TempDir
    Path top;

    private String sweep(ExitCode expected, String folder, String... more) {
        return sweepOver(4, expected, folder, Stream.concat(Stream.of("--scene=3"), Stream.of(more)));
    }

    private String sweepOver(int last, ExitCode expected, String folder, Stream<String> more) {
        return sweepOf(expected, folder, Stream.concat(Stream.of("--vary=springs[0].damping = 0 .. " + last + " by 1;"
                + "deltaT = 0.01, 0.02", "--measure=max x of block, evaluations"), more));
    }

    private String sweepOf(ExitCode expected, String folder, Stream<String> options) {
        String[] args = Stream.concat(Stream.of("sweep", "--out=" + top.resolve(folder)), options)
                .toArray(String[]::new);
        return Screen.of(expected, List.of(new SweepCommand()), OptionStyle.SHELL, args);
    }

    private Path rows(String folder) throws IOException {
        try (Stream<Path> files = Files.list(top.resolve(folder))) {
            return files.filter(file -> file.getFileName().toString().startsWith("rows-")).findFirst().orElseThrow();
        }
    }

    private void assertSame(String one, String other) throws IOException {
        for (String file : FILES) {
            assertArrayEquals(Files.readAllBytes(top.resolve(one).resolve(file)),
                    Files.readAllBytes(top.resolve(other).resolve(file)), file);
        }
    }

    @Test
    void partsJoinedAreTheBytesOfOneRun() throws IOException {
        sweep(ExitCode.DONE, "whole");
        assertEquals(11, Files.readAllLines(top.resolve("whole/sweep.csv")).size());
        for (int k = 1; k <= 3; k++) {
            assertHas(sweep(ExitCode.DONE, k == 2 ? "parts" : "parts/other", "--part=" + k + "/3"), "make the results");
            if (k < 3) {
                assertHas(sweep(ExitCode.BAD_INPUT, "joined", "--collect=" + top.resolve("parts")),
                        " of 10 runs are not in");
            }
        }
        sweep(ExitCode.DONE, "joined", "--collect=" + top.resolve("parts"));
        assertSame("whole", "joined");
    }

    @Test
    void aSweepThatWasStoppedGoesOn() throws IOException {
        sweep(ExitCode.DONE, "whole");
        List<String> lines = Files.readAllLines(rows("whole"));
        Path stopped = top.resolve("stopped").resolve(rows("whole").getFileName());
        Files.createDirectories(stopped.getParent());
        // five runs, one of them changed to see that it is not computed again, and the beginning of a sixth
        String changed = lines.get(3).replaceFirst(",done$", ",not computed again");
        Files.writeString(stopped, String.join("\n", lines.get(0), lines.get(1), lines.get(2), changed, lines.get(4),
                lines.get(5), lines.get(6).substring(0, 3)));
        sweep(ExitCode.DONE, "stopped");
        List<String> again = Files.readAllLines(top.resolve("stopped/sweep.csv"));
        assertTrue(again.stream().anyMatch(line -> line.endsWith(",not computed again")), again.toString());
        List<String> whole = Files.readAllLines(top.resolve("whole/sweep.csv"));
        assertEquals(whole, again.stream().map(line -> line.replace("not computed again", "done")).toList());
    }

    @ParameterizedTest
    @ValueSource(strings = {"x,y,z", "1", "0,0.01,one,2,done"})
    void aLineThatIsNoRowIsRefused(String line) throws IOException {
        sweep(ExitCode.DONE, "rows");
        Files.writeString(rows("rows"), line + "\n", StandardOpenOption.APPEND);
        assertHas(sweep(ExitCode.BAD_INPUT, "rows"), rows("rows") + ": row 11 is none of this sweep");
    }

    @Test
    void rowsOfOtherValuesStayInTheFile() throws IOException {
        sweep(ExitCode.DONE, "rows");
        Path file = rows("rows");
        List<String> before = Files.readAllLines(file);
        sweepOver(2, ExitCode.DONE, "rows", Stream.of("--scene=3"));
        assertEquals(before, Files.readAllLines(file));
        sweepOver(5, ExitCode.DONE, "rows", Stream.of("--scene=3"));
        assertEquals(before, Files.readAllLines(file).subList(0, before.size()));
        assertEquals(before.size() + 2, Files.readAllLines(file).size());
    }

    /** The scene alone is wrong: a duration of 5 s is too many steps. */
    @Test
    void aSceneMayNeedItsSettings() throws IOException {
        Path scene = Files.writeString(top.resolve("scene.yaml"), Files.readString(Path.of(
                "scenes/03-damped-spring.yaml")).replaceFirst("(?m)^deltaT: \\S+", "deltaT: 1e-12"));
        sweepOver(1, ExitCode.DONE, "set", Stream.of("--scene=" + scene, "--set=deltaT=0.01"));
    }

    /** A class that the effect names decides, too; without a class of one's own, none does. */
    @Test
    void rowsDependOnTheSourcesOfOwnClasses() throws IOException {
        Path folder = Files.createDirectories(top.resolve("exercises"));
        Files.writeString(folder.resolve("Push.java"), """
                package exercises;

                class Push {
                    static final double FORCE = 1;
                }
                """);
        Files.writeString(folder.resolve("Pusher.java"), PUSHER);
        Path scene = Files.writeString(top.resolve("scene.yaml"), """
                title: A test
                teaches: A test.
                solver: rk4
                deltaT: 0.01
                duration: 1
                particles:
                  - {id: a, position: [0, 0, 0]}
                effects:
                  - exercises.Pusher
                """);
        assertEquals(0.5, pushed(folder, scene), 1e-12);
        Path none = Files.writeString(top.resolve("none.yaml"), Files.readString(scene).replace("exercises.Pusher",
                "gravity"));
        assertEquals(0, pushed(folder, none), 1e-12);
        Files.writeString(folder.resolve("Push.java"), Files.readString(folder.resolve("Push.java"))
                .replace("= 1", "= 3"));
        assertEquals(1.5, pushed(folder, scene), 1e-12);
        assertEquals(0, pushed(folder, none), 1e-12);
        try (Stream<Path> files = Files.list(top.resolve("pushed"))) {
            assertEquals(3, files.filter(file -> file.getFileName().toString().startsWith("rows-")).count());
        }
    }

    private double pushed(Path folder, Path scene) throws IOException {
        ClassLoader before = Thread.currentThread().getContextClassLoader();
        new StudentLoader(folder).install();
        try {
            sweepOf(ExitCode.DONE, "pushed", Stream.of("--scene=" + scene, "--vary=duration = 1", "--measure=x of a"));
        } finally {
            Thread.currentThread().setContextClassLoader(before);
        }
        return Double.parseDouble(Files.readAllLines(top.resolve("pushed/sweep.csv")).get(1).split(",")[1]);
    }

    /** On some systems names that differ in case are one file, and letters may be missing in a locale. */
    @Test
    void eachMeasureHasAPictureOfItsOwn() throws IOException {
        Path scene = Files.writeString(top.resolve("scene.yaml"), """
                title: A test
                teaches: A test.
                solver: rk4
                deltaT: 0.01
                duration: 0.1
                particles:
                  - {id: "\u00e4", position: [0, 0, 0]}
                  - {id: "\u00f6", position: [0, 0, 0]}
                  - {id: a, position: [0, 0, 0]}
                  - {id: A, position: [0, 0, 0]}
                """);
        assertHas(sweepOf(ExitCode.DONE, "names", Stream.of("--scene=" + scene, "--vary=duration = 0.1, 0.2",
                "--measure=x of \u00e4, x of \u00f6, x of a, x of A")), "Every run:");
        for (String name : List.of("x-of", "x-of-2", "x-of-a", "x-of-A-2")) {
            assertTrue(Files.exists(top.resolve("names").resolve(name + ".png")), name);
        }
        assertHas(Files.readString(top.resolve("names/sweep.md")), "2 runs.");
    }

    /** Rows of other measures, or of another scene, have a file of their own. */
    @Test
    void rowsOfAnotherSweepAreLeftAlone() throws IOException {
        sweep(ExitCode.DONE, "both");
        Path first = rows("both");
        byte[] before = Files.readAllBytes(first);
        sweep(ExitCode.DONE, "both", "--set=springs[0].stiffness=50");
        assertArrayEquals(before, Files.readAllBytes(first));
        assertFalse(Files.readAllLines(top.resolve("both/sweep.csv")).equals(Files.readAllLines(first)));
    }
}
