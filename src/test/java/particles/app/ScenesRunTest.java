package particles.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Texts.assertHas;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import particles.app.cli.ExitCode;
import particles.app.cli.OptionStyle;
import particles.app.cli.Screen;
import particles.app.run.RunCommand;
import particles.app.run.StopRequest;
import particles.scene.SceneFiles.SceneName;
import particles.scene.SceneReader;
import particles.scene.format.SceneDescription;

/** Runs every scene for its first steps: all files are written, and nothing is printed to the error stream. */
@Tag("slow")
class ScenesRunTest {
    private static final Path SCENES = Path.of("scenes");
    private static final int STEPS = 60;

    @ParameterizedTest
    @MethodSource("particles.scene.TestScenes#files")
    void everySceneWritesAllItsFiles(Path file, @TempDir Path out) {
        SceneDescription scene = SceneReader.read(file);
        double duration = Math.min(scene.duration(), STEPS * scene.deltaT());
        Screen screen = Screen.of(List.of(new RunCommand(SCENES, new StopRequest())), OptionStyle.SHELL, "run",
                "--scene=" + SceneName.of(file).number(), "--duration=" + duration, "--out=" + out);
        assertEquals(new Screen(ExitCode.DONE, screen.out(), ""), screen);
        assertHas(screen.out(), scene.title());
        for (String name : List.of("frames/frame-00000.png", "animation.gif", "energy.png", "trajectory.csv",
                "run.json")) {
            assertTrue(Files.isRegularFile(out.resolve(name)), name);
        }
        assertEquals(scene.output().phase().isPresent(), Files.isRegularFile(out.resolve("phase.png")), "phase.png");
    }
}
