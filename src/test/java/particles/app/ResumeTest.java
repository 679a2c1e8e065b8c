package particles.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import particles.scene.Overrides;
import particles.scene.SceneBuilder;
import particles.scene.SceneDescription;
import particles.scene.SceneFiles;
import particles.scene.SceneReader;

/** A run that was interrupted, twice, and continued leaves what an unbroken one does, to the last byte. */
class ResumeTest {
    private static final Path SCENES = Path.of("scenes");
    /** Steps between checkpoints: no divisor of anything. */
    private static final int EVERY = 13;
    private static final CheckpointPace ALWAYS = new CheckpointPace(EVERY, 0, Double.POSITIVE_INFINITY);
    /** Particles times steps of a run without pictures: a few tenths of a second each. */
    private static final double MOST_WORK = 1e5;
    private static final int MOST_STEPS = 4000;
    private static final int STEPS_WITH_FRAMES = 60;

    @TempDir
    Path top;
    private final StringWriter errors = new StringWriter();

    static List<Path> scenes() {
        return SceneFiles.list(SCENES);
    }

    /** Stops a run after so many steps. */
    private static final class StopAfter extends StopRequest {
        private long left;

        StopAfter(long steps) {
            left = steps;
        }

        @Override
        boolean isWanted() {
            return --left < 0;
        }
    }

    private ExitCode run(Path out, long stopAfter, CheckpointPace pace, String... options) {
        List<String> args = new ArrayList<>(List.of("run", "--out=" + out));
        args.addAll(List.of(options));
        errors.getBuffer().setLength(0);
        RunCommand command = new RunCommand(SCENES, OptionStyle.GRADLE, new StopAfter(stopAfter), pace);
        return new Program(List.of(command), OptionStyle.GRADLE, new PrintWriter(new StringWriter()), new PrintWriter(errors))
                .execute(args.toArray(String[]::new));
    }

    private void assertResumes(int steps, String... options) throws IOException {
        Path whole = top.resolve("whole");
        Path broken = top.resolve("broken");
        assertEquals(ExitCode.DONE, run(whole, Long.MAX_VALUE, ALWAYS, options), errors.toString());
        List<String> more = new ArrayList<>(List.of(options));
        assertEquals(ExitCode.STOPPED, run(broken, steps / 3, ALWAYS, more.toArray(String[]::new)), errors.toString());
        assertTrue(errors.toString().contains("-Presume=true continues it"), errors.toString());
        assertNotEquals(WholeFiles.sums(whole), WholeFiles.sums(broken));
        more.add("--resume=true");
        assertEquals(ExitCode.STOPPED, run(broken, steps / 3, ALWAYS, more.toArray(String[]::new)), errors.toString());
        assertEquals(ExitCode.DONE, run(broken, Long.MAX_VALUE, ALWAYS, more.toArray(String[]::new)), errors.toString());
        assertEquals(WholeFiles.sums(whole), WholeFiles.sums(broken));
    }

    @ParameterizedTest
    @MethodSource("scenes")
    @Tag("slow")
    void everySceneHasTheSameBits(Path file) throws IOException {
        SceneDescription scene = SceneReader.read(file);
        int particles = SceneBuilder.build(scene, new Overrides()).system().getParticles().count();
        double affordable = Math.min(MOST_STEPS, MOST_WORK / particles);
        int steps = (int) Math.max(STEPS_WITH_FRAMES, Math.min(affordable, scene.duration() / scene.deltaT()));
        assertResumes(steps, "--scene=" + file, "--frames=false", "--duration=" + steps * scene.deltaT());
    }

    @ParameterizedTest
    @MethodSource("scenes")
    @Tag("slow")
    void everySceneHasTheSamePictures(Path file) throws IOException {
        double duration = STEPS_WITH_FRAMES * SceneReader.read(file).deltaT();
        assertResumes(STEPS_WITH_FRAMES, "--scene=" + file, "--duration=" + duration);
    }

    /** What began before the interruption is seen after it. */
    @Test
    void trailsAndFilmsGoOn() throws IOException {
        Path scene = Files.writeString(top.resolve("trail.yaml"), Files.readString(SCENES.resolve("04-pendulum.yaml"))
                .replaceAll("(?ms)^(look|output):.*?(?=^\\S|\\z)", "")
                + "\nlook: {trail: 0.5}\noutput: {frameRate: 25, width: 96, height: 64, video: mp4}\n");
        assertResumes(60, "--scene=" + scene, "--deltaT=0.01", "--duration=0.6");
        assertTrue(Files.exists(top.resolve("broken").resolve("film.mp4")));
    }

    /** Those that remember most of earlier steps. */
    @ParameterizedTest
    @ValueSource(strings = {"adams", "verlet", "bulirsch-stoer", "dormand-prince", "radau", "step-doubling"})
    void solversForgetAtCheckpoints(String solver) throws IOException {
        assertResumes(100, "--scene=pendulum", "--frames=false", "--solver=" + solver, "--deltaT=0.005", "--duration=0.5");
    }

    /** Were the solver not told to forget in the unbroken run too, its bits would differ. */
    @Test
    void checkpointsArePartOfWhatARunComputes() throws IOException {
        String[] options = {"--scene=pendulum", "--frames=false", "--solver=adams", "--deltaT=0.005", "--duration=0.5"};
        assertEquals(ExitCode.DONE, run(top.resolve("often"), Long.MAX_VALUE, ALWAYS, options));
        assertEquals(ExitCode.DONE, run(top.resolve("once"), Long.MAX_VALUE, CheckpointPace.USUAL, options));
        assertNotEquals(WholeFiles.sums(top.resolve("often")).get("trajectory.csv"),
                WholeFiles.sums(top.resolve("once")).get("trajectory.csv"));
    }

    private void assertRefused(String line, Path out, String... options) {
        List<String> args = new ArrayList<>(List.of(options));
        args.add("--resume=true");
        assertEquals(ExitCode.BAD_INPUT, run(out, Long.MAX_VALUE, ALWAYS, args.toArray(String[]::new)));
        assertEquals(line, errors.toString().strip());
    }

    @Test
    void whatCannotBeContinuedIsSaid() throws IOException {
        Path out = top.resolve("out");
        Path scene = Files.copy(SCENES.resolve("04-pendulum.yaml"), top.resolve("pendulum.yaml"));
        String[] options = {"--scene=" + scene, "--frames=false", "--duration=1"};
        assertRefused("-Presume: no run that could be continued is in " + out + "; leave the option away to begin one", out,
                options);
        assertFalse(Files.exists(out), "nothing was written");
        assertEquals(ExitCode.STOPPED, run(out, 50, ALWAYS, options));
        assertRefused("-Presume: the run in " + out + " is of the scene 'pendulum', not of '02-one-spring'", out,
                "--scene=one-spring", "--frames=false", "--duration=1");
        assertRefused("-Presume: the run in " + out + " was begun with -Psolver=rk4, not euler", out,
                "--scene=" + scene, "--frames=false", "--duration=1", "--solver=euler");
        assertRefused("-Presume: the run in " + out + " was begun with -Pduration=1, not 2", out,
                "--scene=" + scene, "--frames=false", "--duration=2");
        assertRefused("-Presume: the run in " + out + " was begun with -Pframes=false, not true", out,
                "--scene=" + scene, "--duration=1");
        Files.writeString(scene, Files.readString(scene) + "# another line\n");
        assertRefused("-Presume: " + scene + " has changed since the run in " + out
                + " began; leave the option away to begin anew",
                out, options);
        Files.copy(SCENES.resolve("04-pendulum.yaml"), scene, StandardCopyOption.REPLACE_EXISTING);
        assertEquals(ExitCode.DONE, run(out, Long.MAX_VALUE, ALWAYS, options[0], options[1], options[2], "--resume"));
        assertRefused("-Presume: the run in " + out + " is complete; there is nothing to continue", out, options);
    }

    @Test
    void aDamagedCheckpointIsNotContinued() throws IOException {
        Path out = top.resolve("out");
        String[] options = {"--scene=pendulum", "--frames=false", "--duration=1"};
        assertEquals(ExitCode.STOPPED, run(out, 50, ALWAYS, options));
        Path file = out.resolve("checkpoint");
        byte[] bytes = Files.readAllBytes(file);
        for (int k : new int[] {0, bytes.length / 2, bytes.length - 1}) {
            byte[] damaged = bytes.clone();
            damaged[k] ^= 1;
            Files.write(file, damaged);
            assertEquals(ExitCode.TROUBLE, run(out, Long.MAX_VALUE, ALWAYS, options[0], options[1], options[2], "--resume"));
            assertEquals("cannot continue from " + file + ": it is damaged; the run has to begin anew",
                    errors.toString().strip());
        }
        Files.write(file, bytes);
        Files.writeString(out.resolve("trajectory.csv"), "time\n");
        assertEquals(ExitCode.TROUBLE, run(out, Long.MAX_VALUE, ALWAYS, options[0], options[1], options[2], "--resume"));
        assertEquals("cannot continue " + out.resolve("trajectory.csv")
                + ": it is not as long any more as when the run was interrupted",
                errors.toString().strip());
    }

    /** A new run into the folder begins anew, and the old one's checkpoint is gone. */
    @Test
    void withoutTheOptionARunBeginsAnew() throws IOException {
        Path out = top.resolve("out");
        String[] options = {"--scene=pendulum", "--frames=false", "--duration=1"};
        assertEquals(ExitCode.STOPPED, run(out, 50, ALWAYS, options));
        assertTrue(Files.exists(out.resolve("checkpoint")));
        assertEquals(ExitCode.STOPPED, run(out, 5, ALWAYS, options));
        assertFalse(errors.toString().contains("resume"), errors.toString());
        assertFalse(Files.exists(out.resolve("checkpoint")));
    }
}
