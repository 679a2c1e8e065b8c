package particles.scene.checks;

import deSolvers.text.Digits;
import java.util.Map;
import particles.scene.format.SceneDescription;
import particles.scene.format.SceneFormat;
import particles.spec.Key;
import particles.spec.messages.Place;
import particles.spec.messages.Problems;

/** Limits on the numbers of steps and pictures of a run: more can only be a typing error. */
public final class RunLimits {
    private static final double MOST_STEPS = 1e10;
    private static final double MOST_FRAMES = 1e6;
    private static final double SOME_FRAMES = 1000;

    private RunLimits() {
    }

    /** Adds a problem if a run would have too many steps. */
    public static void check(double deltaT, double duration, Map<Key<?>, Place> places, Problems problems) {
        if (duration / deltaT > MOST_STEPS) {
            problems.add(places.get(SceneFormat.DURATION), "a duration of " + Digits.exact(duration) + " s is "
                    + Digits.few(duration / deltaT) + " steps of deltaT = " + Digits.exact(deltaT)
                    + " s; a run can have at most 1e10");
        }
    }

    /**
     * Checks the number of pictures of a run.
     *
     * @param scene    the scene to run
     * @param option   the option that turns pictures off, as typed
     * @param problems receives a problem if there would be too many
     */
    public static void checkPictures(SceneDescription scene, String option, Problems problems) {
        double frameRate = scene.output().frames().rate();
        if (scene.output().frames().drawn() && scene.duration() * frameRate > MOST_FRAMES) {
            problems.add(scene.places().get(SceneFormat.DURATION), "a duration of "
                    + Digits.exact(scene.duration()) + " s needs more than a million pictures at frameRate = "
                    + Digits.exact(frameRate) + "; in the scene, output: {frameRate: "
                    + Digits.roundedDown(SOME_FRAMES / scene.duration()) + "} draws " + (int) SOME_FRAMES + ", and "
                    + option + "=false none");
        }
    }
}
