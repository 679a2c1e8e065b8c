package particles.app;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.Stream;
import particles.app.cli.ExitCode;
import particles.app.cli.OptionStyle;
import particles.app.cli.Program;
import particles.app.run.RunCommand;
import particles.app.run.StopRequest;
import particles.scene.SceneBuilder;
import particles.scene.SceneFiles;
import particles.scene.SceneReader;
import particles.scene.format.SceneDescription;

/**
 * Runs all scenes of a folder in this process and prints the SHA-256 of each trajectory, one line a scene, and a last
 * line that says whether helper threads worked; {@link SameBitsTest} compares them between processes.
 */
final class SceneSums {
    /** The beginning of the last line. */
    static final String HELPED = "helped";
    /** Particles times steps of a run: a few tenths of a second each. */
    private static final double MOST_WORK = 1e5;
    private static final int LEAST_STEPS = 40;
    private static final int MOST_STEPS = 1500;

    private SceneSums() {
    }

    /** Checks every millisecond whether another thread is evaluating effects. */
    private static final class Lookout extends Thread {
        private volatile boolean helped;

        Lookout() {
            super("lookout");
            setDaemon(true);
        }

        @Override
        public void run() {
            while (!helped) {
                helped = Thread.getAllStackTraces().entrySet().stream()
                        .filter(thread -> thread.getKey().getName().startsWith("forces-"))
                        .flatMap(thread -> Stream.of(thread.getValue()))
                        .anyMatch(call -> call.getClassName().startsWith("particles.effects."));
                LockSupport.parkNanos(1_000_000);
            }
        }
    }

    /** @param args the folder of scenes, an empty one to write to, and further options of {@code run} */
    public static void main(String[] args) throws IOException {
        Path scenes = Path.of(args[0]);
        Path out = Path.of(args[1]);
        List<String> more = List.of(args).subList(2, args.length);
        Lookout lookout = new Lookout();
        lookout.start();
        for (Path file : SceneFiles.list(scenes)) {
            System.out.println(file.getFileName() + " " + sum(scenes, file, out, more));
            try (Stream<Path> files = Files.walk(out)) {
                files.sorted(Comparator.reverseOrder()).forEach(path -> path.toFile().delete());
            }
        }
        System.out.println(HELPED + " " + lookout.helped);
    }

    /** A duration with a limited number of steps, the same in every process. */
    static double duration(SceneDescription scene) {
        int particles = SceneBuilder.build(scene).system().getParticles().count();
        double steps = Math.min(MOST_STEPS, Math.max(LEAST_STEPS, MOST_WORK / particles));
        return Math.min(scene.duration(), Math.floor(steps) * scene.deltaT());
    }

    private static String sum(Path scenes, Path file, Path out, List<String> more) throws IOException {
        SceneDescription scene = SceneReader.read(file);
        List<String> args = new ArrayList<>(List.of("run", "--scene=" + file, "--out=" + out));
        args.addAll(more);
        args.add("--duration=" + duration(scene));
        StringWriter lines = new StringWriter();
        ExitCode code = new Program(List.of(new RunCommand(scenes, OptionStyle.SHELL, new StopRequest())),
                OptionStyle.SHELL,
                new PrintWriter(lines), new PrintWriter(lines)).execute(args.toArray(String[]::new));
        return code == ExitCode.DONE ? WholeFiles.sums(out).get("trajectory.csv") : code + ": " + lines;
    }
}
