package particles.app;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import particles.app.cli.ExitCode;
import particles.app.cli.OptionStyle;
import particles.app.cli.Screen;
import particles.app.run.RunCommand;
import particles.app.run.StopRequest;
import particles.app.student.StudentClasses;
import particles.output.files.TemporaryFolder;
import particles.scene.SceneBuilder;
import particles.scene.SceneFiles;
import particles.scene.SceneReader;
import particles.scene.format.SceneDescription;

/**
 * Runs all scenes of a folder in this process and prints the SHA-256 of each trajectory, one line a scene;
 * {@link SameBitsTest} compares them between processes.
 */
final class SceneSums {
    /** Particles times steps of a run: a few tenths of a second each. */
    private static final double MOST_WORK = 1e5;
    private static final int LEAST_STEPS = 40;
    private static final int MOST_STEPS = 1500;

    private SceneSums() {
    }

    /** @param args the folder of scenes, an empty one to write to, and further options of {@code run} */
    public static void main(String[] args) throws IOException {
        Path scenes = Path.of(args[0]);
        Path out = Path.of(args[1]);
        List<String> more = List.of(args).subList(2, args.length);
        for (Path file : SceneFiles.list(scenes)) {
            System.out.println(file.getFileName() + " " + sum(scenes, file, out, more));
            TemporaryFolder.delete(out);
        }
    }

    /** A duration with a limited number of steps, the same in every process. */
    static double duration(SceneDescription scene) {
        int particles = SceneBuilder.build(scene).system().getParticles().count();
        double steps = Math.min(MOST_STEPS, Math.max(LEAST_STEPS, MOST_WORK / particles));
        return Math.min(scene.duration(), Math.floor(steps) * scene.deltaT());
    }

    private static String sum(Path scenes, Path file, Path out, List<String> more) throws IOException {
        SceneDescription scene = SceneReader.read(file, new StudentClasses());
        List<String> args = new ArrayList<>(List.of("run", "--scene=" + file, "--out=" + out));
        args.addAll(more);
        args.add("--duration=" + duration(scene));
        Screen screen = Screen.of(List.of(new RunCommand(scenes, new StopRequest())), OptionStyle.SHELL,
                args.toArray(String[]::new));
        return screen.code() == ExitCode.DONE ? WholeFiles.sums(out).get("trajectory.csv") : screen.toString();
    }
}
