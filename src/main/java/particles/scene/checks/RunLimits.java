package particles.scene.checks;

import deSolvers.text.Digits;
import java.util.Optional;
import particles.scene.format.SceneDescription;
import particles.scene.format.SceneFormat;
import particles.spec.Values;
import particles.spec.messages.InvalidInputException;
import particles.spec.messages.Problems;

/** Limits on the numbers of steps and pictures of a run: more can only be a typing error. */
public final class RunLimits {
    private static final double MOST_STEPS = 1e10;
    private static final double MOST_FRAMES = 1e6;
    private static final double SOME_FRAMES = 1000;

    private RunLimits() {
    }

    /** Adds a problem if the run has too many steps; values that are missing or wrong have their own. */
    public static void check(Values scene, Problems problems) {
        Optional<Double> deltaT = scene.find(SceneFormat.DELTA_T);
        double duration = scene.find(SceneFormat.DURATION).orElse(0.0);
        if (deltaT.isPresent() && duration / deltaT.get() > MOST_STEPS) {
            problems.add(scene.place(SceneFormat.DURATION), "a duration of " + Digits.exact(duration) + " s is "
                    + Digits.few(duration / deltaT.get()) + " steps of deltaT = " + Digits.exact(deltaT.get())
                    + " s; a run can have at most 1e10");
        }
    }

    /**
     * Checks the number of pictures of a run.
     *
     * @param scene  the scene to run
     * @param option the option that turns pictures off, as typed
     * @throws InvalidInputException if there would be too many
     */
    public static void checkPictures(SceneDescription scene, String option) {
        double frameRate = scene.output().frames().rate();
        if (scene.output().frames().drawn() && scene.duration() * frameRate > MOST_FRAMES) {
            throw new InvalidInputException(scene.values().place(SceneFormat.DURATION) + ": a duration of "
                    + Digits.exact(scene.duration()) + " s needs more than a million pictures at frameRate = "
                    + Digits.exact(frameRate) + "; in the scene, output: {frameRate: "
                    + Digits.roundedDown(SOME_FRAMES / scene.duration(), 2) + "} draws " + (int) SOME_FRAMES + ", and "
                    + option + "=false none");
        }
    }
}
