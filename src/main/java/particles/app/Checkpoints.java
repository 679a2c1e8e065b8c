package particles.app;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.LongSupplier;
import particles.output.Checkpoint;
import particles.output.OutputFolder;
import particles.scene.OutputDescription.Video;
import particles.scene.Scene;

/** Writes a run down from time to time, so that it can be continued, and finds what was written. */
final class Checkpoints {
    private static final double NANO = 1e-9;

    private final Path file;
    private final Scene scene;
    private final Map<String, String> identity = new LinkedHashMap<>();
    private double due;

    /**
     * @param file   the scene's
     * @param scene  the scene, about to run
     * @param frames whether pictures are drawn
     * @param video  which film is made of them
     */
    Checkpoints(Path file, Scene scene, boolean frames, Video video) {
        this.file = file;
        this.scene = scene;
        identity.put("scene", SceneName.of(file).whole());
        identity.put("solver", scene.description().solver());
        identity.put("deltaT", Digits.exact(scene.simulation().getDeltaT()));
        identity.put("duration", Digits.exact(scene.simulation().getDuration()));
        identity.put("frames", Boolean.toString(frames));
        identity.put("video", video.label());
        identity.put("sceneSha256", scene.description().sha256());
        identity.put("version", Version.CURRENT);
    }

    /**
     * Looks for the run that is to be continued.
     *
     * @param results the folder of its results
     * @param style   how options are typed
     * @return its last checkpoint
     * @throws Failure if there is none, or if it is of another run than this one
     */
    Checkpoint find(Path results, OptionStyle style) {
        String option = style.option("resume");
        if (!Checkpoint.isIn(results)) {
            throw new Failure(ExitCode.BAD_INPUT, option + ": " + (FinishedRun.isIn(results) ? "the run in " + results
                    + " is complete; there is nothing to continue" : "no run that could be continued is in " + results
                    + "; leave the option away to begin one"));
        }
        Checkpoint checkpoint = Checkpoint.read(results);
        identity.forEach((name, now) -> {
            String then = checkpoint.getIdentity().getOrDefault(name, "");
            if (!then.equals(now)) {
                throw new Failure(ExitCode.BAD_INPUT, option + ": " + difference(name, then, now, results, style));
            }
        });
        return checkpoint;
    }

    private String difference(String name, String then, String now, Path results, OptionStyle style) {
        return switch (name) {
            case "scene" -> "the run in " + results + " is of the scene '" + then + "', not of '" + now + "'";
            case "sceneSha256" -> file + " has changed since the run in " + results
                    + " began; leave the option away to begin anew";
            case "version" -> "the run in " + results + " was begun by version " + then + " of the program, and this is " + now;
            default -> "the run in " + results + " was begun with " + style.option(name) + "=" + then + ", not " + now;
        };
    }

    /**
     * From now on the run is written down from time to time.
     *
     * @param folder   where to
     * @param pace     how often
     * @param nanoTime a clock, such as {@link System#nanoTime}
     */
    void writeTo(OutputFolder folder, CheckpointPace pace, LongSupplier nanoTime) {
        due = nanoTime.getAsLong() * NANO + pace.pause();
        scene.simulation().setCheckpoints(pace.steps(), () -> {
            double begin = nanoTime.getAsLong() * NANO;
            if (begin >= due) {
                Checkpoint.write(folder, identity, scene.simulation()::remember);
                double end = nanoTime.getAsLong() * NANO;
                due = end + Math.max(pace.pause(), (end - begin) / pace.share());
            }
        });
    }
}
