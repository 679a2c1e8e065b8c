package particles.app.run;

import deSolvers.text.Digits;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;
import particles.Motion;
import particles.Observer;
import particles.scene.Scene;
import particles.scene.SceneBuilder;
import particles.scene.format.OutputDescription.Frames;
import particles.scene.format.SceneDescription;

/**
 * Estimates the time of a long run before it begins. A copy of the scene makes the first steps, which are timed, and
 * the rest is assumed to be like them; a scene in which more and more happens takes longer.
 */
final class TimeEstimate {
    private static final double NANO = 1e-9;
    /** Particles times steps of a run that is over at once with any solver. */
    private static final double LITTLE = 1e5;
    /** A run of this time or more is announced (s). */
    private static final double LONG = 10;
    /** The time for which the copy's first steps are measured (s), and the last ones, when Java has warmed up. */
    private static final double FIRST_SPAN = 0.1;
    private static final double LAST_SPAN = 0.8;
    /** The longest wait for the first steps (ms); each may take minutes. */
    private static final long PATIENCE = 2000;
    /** The overhead of a step, expressed as a number of particles. */
    private static final double OVERHEAD = 100;
    /** A picture's share of the time, beside the simulation on another core (s for a pixel). */
    private static final double PER_PIXEL = 2e-8;

    private TimeEstimate() {
    }

    /**
     * @param scene what is to be run
     * @return a line, if the run takes long
     */
    static Optional<String> of(SceneDescription scene) {
        double steps = Math.ceil(scene.duration() / scene.deltaT());
        double atStart = scene.particlesAfter(0);
        double particles = Math.max(atStart, scene.particlesAfter(scene.duration()));
        if (steps * Math.max(1, particles) < LITTLE) {
            return Optional.empty();
        }
        Frames frames = scene.output().frames();
        double pictures = frames.drawn() ? scene.duration() * frames.rate() : 0;
        double drawing = pictures * PER_PIXEL * frames.width() * frames.height();
        double stepping = seconds(SceneBuilder.build(scene), steps, System::nanoTime, PATIENCE);
        double mean = scene.particlesAfter(scene.duration() / 2);
        double growth = (mean + OVERHEAD) / (atStart + OVERHEAD);
        double seconds = Math.max(drawing, stepping * Math.max(1, growth));
        return seconds < LONG ? Optional.empty() : Optional.of(line(seconds, steps,
                (growth > 1 ? "up to " : "") + counted(particles), pictures));
    }

    static String line(double seconds, double steps, String particles, double pictures) {
        return "this takes about " + time(seconds) + ": " + Digits.few(steps) + " steps of " + particles
                + (pictures > 0 ? " and " + Digits.few(Math.ceil(pictures)) + " pictures" : "");
    }

    static String counted(double particles) {
        return String.format(Locale.ROOT, "%.0f particle%s", Math.ceil(particles), particles == 1 ? "" : "s");
    }

    /** The time in the largest unit in which it is more than one. */
    static String time(double seconds) {
        return seconds < 100 ? in(seconds, 1, " s") : seconds < 6000 ? in(seconds, 60, " min")
                : seconds < 172_800 ? in(seconds, 3600, " h") : in(seconds, 86_400, " days");
    }

    private static String in(double seconds, double unit, String name) {
        return Digits.few(Math.ceil(seconds / unit)) + name;
    }

    /**
     * Runs a scene for a short while, in a thread of its own, as one step may take very long.
     *
     * @param nanoTime a clock, such as {@link System#nanoTime}
     * @param patience the longest wait (ms)
     * @return the time of the whole run (s); if no step ended in time, a lower bound
     */
    static double seconds(Scene copy, double steps, LongSupplier nanoTime, long patience) {
        Stopwatch watch = new Stopwatch(steps, nanoTime);
        copy.simulation().addObserver(watch);
        CompletableFuture<Void> trial = CompletableFuture.runAsync(copy.simulation()::run, TimeEstimate::start);
        // if the trial fails, so will the run, with its own message
        trial.exceptionally(end -> null).completeOnTimeout(null, patience, TimeUnit.MILLISECONDS).join();
        watch.enough = true;
        return watch.seconds > 0 || trial.isDone() ? watch.seconds : steps / (watch.made + 1) * patience / 1000;
    }

    private static void start(Runnable task) {
        Thread thread = new Thread(task, "time estimate");
        thread.setDaemon(true);
        thread.start();
    }

    /**
     * Looks at the clock after every step, and ends the run when it has seen enough: each span is twice the one before.
     */
    private static final class Stopwatch implements Observer {
        private final double steps;
        private final LongSupplier nanoTime;
        private volatile boolean enough;
        private volatile double seconds;
        private double span = FIRST_SPAN;
        private double begin;
        private volatile int made;

        Stopwatch(double steps, LongSupplier nanoTime) {
            this.steps = steps;
            this.nanoTime = nanoTime;
            begin = nanoTime.getAsLong() * NANO;
        }

        @Override
        public void moved(Motion motion) {
            made += 1;
            double time = nanoTime.getAsLong() * NANO - begin;
            if (enough) {
                throw new StoppedException();
            }
            if (time < span) {
                return;
            }
            seconds = steps * time / made;
            if (seconds < LONG || span >= LAST_SPAN) {
                throw new StoppedException();
            }
            begin += time;
            made = 0;
            span *= 2;
        }
    }
}
