package particles.scene.checks;

import java.util.Map;
import particles.scene.format.SceneFormat;
import particles.spec.Key;
import particles.spec.messages.Place;
import particles.spec.messages.Problems;
import particles.spec.messages.Wording;

/** How long a run may be, in steps and pictures, before it can only be a slip of the finger. */
public final class RunLimits {
    private static final double MOST_STEPS = 1e10;
    private static final double MOST_FRAMES = 1e6;

    private RunLimits() {
    }

    public static void check(double deltaT, double duration, double frameRate, Map<Key<?>, Place> places,
            Problems problems) {
        if (duration / deltaT > MOST_STEPS) {
            problems.add(places.get(SceneFormat.DURATION), "a duration of " + Wording.number(duration)
                    + " s needs more than 1e10 steps of deltaT = "
                    + Wording.number(deltaT) + " s");
        }
        if (duration * frameRate > MOST_FRAMES) {
            problems.add(places.get(SceneFormat.DURATION), "a duration of " + Wording.number(duration)
                    + " s needs more than a million pictures at frameRate = " + Wording.number(frameRate));
        }
    }
}
