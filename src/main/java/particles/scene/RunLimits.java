package particles.scene;

import deSolvers.text.Digits;
import java.util.Locale;
import java.util.Optional;
import particles.scene.format.SceneDescription;
import particles.scene.format.SceneFormat;
import particles.spec.Values;
import particles.spec.messages.InvalidInputException;
import particles.spec.messages.Problems;

/** Limits of a run: numbers of steps and pictures beyond which there can only be a typing error, and its memory. */
public final class RunLimits {
    private static final double MOST_STEPS = 1e10;
    private static final double MOST_FRAMES = 1e6;
    private static final double MEGABYTE = 1 << 20;
    /** Nobody is advised to give Java more memory than a large personal computer has. */
    private static final double MOST_GIGABYTES = 64;

    private RunLimits() {
    }

    /** Adds a problem if the run has too many steps; values that are missing or wrong have their own. */
    static void check(Values scene, Problems problems) {
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
                    + Digits.exact(frameRate) + "; give a lower frameRate under 'output', or " + option
                    + "=false for none");
        }
    }

    /**
     * Adds a problem if the scene does not fit.
     *
     * @param allowed the memory that Java may use (bytes)
     */
    static void checkMemory(SceneDescription scene, double allowed, Problems problems) {
        MemoryEstimate needed = MemoryEstimate.of(scene);
        if (needed.bytes() > allowed) {
            double gigabytes = Math.ceil(needed.bytes() / MEGABYTE / 1024);
            String more = gigabytes > MOST_GIGABYTES ? ""
                    : ", or give Java more memory: JAVA_TOOL_OPTIONS=-Xmx" + (int) gigabytes + "g";
            problems.add(scene.values().place(SceneFormat.SHAPES), String.format(Locale.ROOT, """
                    the scene needs about %s MiB of memory for %.0f particles and %.0f springs with %s, and Java may \
                    use %s MiB; use fewer particles%s""", Digits.few(needed.bytes() / MEGABYTE), needed.particles(),
                    needed.springs(), scene.solver(), Digits.few(allowed / MEGABYTE), more));
        }
    }
}
