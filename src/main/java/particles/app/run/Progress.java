package particles.app.run;

import deSolvers.text.Digits;
import java.io.PrintWriter;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;
import particles.Motion;
import particles.Observer;
import particles.ParticleSystem;
import particles.scene.format.OutputDescription.Frames;
import particles.scene.format.SceneDescription;

/**
 * Prints how long a run will take, from the time that its first seconds took, and then its progress: at most one line a
 * second, none for short runs. The time assumes that later steps are like the first ones; a scene in which more and
 * more happens takes longer.
 */
final class Progress implements Observer, AutoCloseable {
    private static final double NANO = 1e-9;
    /** Runs shorter than this print nothing (s). */
    private static final double SILENCE = 2;
    /** A run of this time or more is announced (s). */
    private static final double LONG = 10;
    /** The overhead of a step, expressed as a number of particles. */
    private static final double OVERHEAD = 100;
    /** The least time between two lines (s). */
    private static final double PAUSE = 1;
    /** A line is printed after this fraction of the run, or after a longer time (s). */
    private static final double NEWS = 0.1;
    private static final double LONG_PAUSE = 10;

    private final PrintWriter out;
    private final SceneDescription scene;
    private final LongSupplier nanoTime;
    private final double steps;
    private final long begin;
    private final CompletableFuture<Void> firstStep = new CompletableFuture<>();
    private volatile boolean announced;
    /** The pace is measured from here on, over at least the later half of the run so far: its beginning is slower. */
    private double fromTime;
    private double fromPart;
    private double nextTime;
    private double nextPart;
    private double lastTime;
    private double lastPart;

    /**
     * @param out      the output
     * @param scene    the scene that is run
     * @param nanoTime a clock, such as {@link System#nanoTime}
     */
    Progress(PrintWriter out, SceneDescription scene, LongSupplier nanoTime) {
        this.out = out;
        this.scene = scene;
        this.nanoTime = nanoTime;
        steps = Math.ceil(scene.duration() / scene.deltaT());
        begin = nanoTime.getAsLong();
    }

    /** @return the time since the beginning (s) */
    double seconds() {
        return (nanoTime.getAsLong() - begin) * NANO;
    }

    /** If the first step takes long, the user learns how many there are. */
    @Override
    public void started(ParticleSystem system) {
        firstStep.orTimeout((long) SILENCE, TimeUnit.SECONDS).exceptionally(late -> {
            announced = true;
            out.println("the first step takes over " + Digits.few(SILENCE) + " s: " + work());
            return null;
        });
    }

    @Override
    public void moved(Motion motion) {
        double seconds = seconds();
        double part = motion.getEndTime() / scene.duration();
        if (nextPart == 0) {
            firstStep.complete(null);
        }
        if (nextPart == 0 || seconds >= 2 * nextTime) {
            fromTime = nextPart == 0 ? seconds : nextTime;
            fromPart = nextPart == 0 ? part : nextPart;
            nextTime = seconds;
            nextPart = part;
        }
        if (seconds < SILENCE || part == fromPart) {
            return;
        }
        double pace = (seconds - fromTime) / (part - fromPart);
        if (!announced) {
            announced = true;
            announce(seconds + pace * (1 - part));
        }
        if (seconds - lastTime >= PAUSE && part < 1 && (part - lastPart >= NEWS || seconds - lastTime >= LONG_PAUSE)) {
            double left = Math.ceil(pace * (1 - part));
            out.println("t = " + Digits.few(motion.getEndTime()) + " s of " + Digits.few(scene.duration()) + " s, "
                    + (int) (100 * part) + " %, about " + Digits.few(left) + " s to go");
            lastTime = seconds;
            lastPart = part;
        }
    }

    /** Says nothing more of the first step. */
    @Override
    public void close() {
        firstStep.complete(null);
    }

    /** @param likeNow the time of the run (s) if all steps are like those so far */
    private void announce(double likeNow) {
        double seconds = likeNow * Math.max(1, growth());
        if (seconds >= LONG) {
            out.println("this takes about " + time(seconds) + ": " + work());
        }
    }

    /** The number of particles half way, as a multiple of that at the start; with the overhead of a step. */
    private double growth() {
        return (scene.particlesAfter(scene.duration() / 2) + OVERHEAD) / (scene.particlesAfter(0) + OVERHEAD);
    }

    private String work() {
        double particles = Math.ceil(Math.max(scene.particlesAfter(0), scene.particlesAfter(scene.duration())));
        Frames frames = scene.output().frames();
        double pictures = frames.drawn() ? Math.ceil(scene.duration() * frames.rate()) : 0;
        return Digits.few(steps) + " steps of " + (growth() > 1 ? "up to " : "")
                + Summary.counted((long) particles, "particle")
                + (pictures > 0 ? " and " + Digits.few(pictures) + " pictures" : "");
    }

    /** The time in the largest unit in which it is more than one. */
    static String time(double seconds) {
        return seconds < 100 ? in(seconds, 1, " s") : seconds < 6000 ? in(seconds, 60, " min")
                : seconds < 172_800 ? in(seconds, 3600, " h") : in(seconds, 86_400, " days");
    }

    private static String in(double seconds, double unit, String name) {
        return Digits.few(Math.ceil(seconds / unit)) + name;
    }
}
