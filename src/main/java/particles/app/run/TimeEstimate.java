package particles.app.run;

import java.util.Optional;
import java.util.function.LongSupplier;
import particles.Motion;
import particles.Observer;
import particles.SimulationException;
import particles.messages.Digits;
import particles.messages.Digits;
import particles.scene.Scene;
import particles.scene.SceneBuilder;
import particles.scene.format.Overrides;
import particles.scene.format.SceneDescription;

/**
 * How long a run is going to take, told before it begins where that is long. The first steps are made by a copy of the
 * scene and timed, and the rest is taken to be like them; a scene in which more and more happens takes longer.
 */
final class TimeEstimate {
    private static final double NANO = 1e-9;
    /** Particles times steps of a run that is over at once with any solver. */
    private static final double LITTLE = 1e5;
    /** A run of this time or more is announced (s). */
    private static final double LONG = 10;
    /** How long the copy's first steps are measured (s), and the last ones, when Java has warmed up. */
    private static final double FIRST_SPAN = 0.1;
    private static final double LAST_SPAN = 0.8;
    /** A picture's share of the time, beside the simulation on another core (s for a pixel). */
    private static final double PER_PIXEL = 2e-8;

    private TimeEstimate() {
    }

    /**
     * @param described what the scene's file says
     * @param overrides what goes before it
     * @param frames    whether pictures are drawn
     * @return a line, if the run takes long
     */
    static Optional<String> of(SceneDescription described, Overrides overrides, boolean frames) {
        Scene copy = SceneBuilder.build(described, overrides);
        double steps = Math.ceil(copy.simulation().getDuration() / copy.simulation().getDeltaT());
        int particles = copy.system().getParticles().count();
        if (steps * Math.max(1, particles) < LITTLE) {
            return Optional.empty();
        }
        double pictures = frames ? copy.simulation().getDuration() * copy.output().frameRate() : 0;
        double drawing = pictures * PER_PIXEL * copy.output().width() * copy.output().height();
        double seconds = Math.max(drawing, seconds(copy, steps, System::nanoTime));
        return seconds < LONG ? Optional.empty() : Optional.of(line(seconds, steps, particles, pictures));
    }

    static String line(double seconds, double steps, int particles, double pictures) {
        return "this takes about " + time(seconds) + ": " + Digits.few(steps) + " steps of " + particles
                + (particles == 1 ? " particle" : " particles")
                + (pictures > 0 ? " and " + Digits.few(Math.ceil(pictures)) + " pictures" : "");
    }

    /** In the largest unit that makes it more than one. */
    static String time(double seconds) {
        if (seconds < 100) {
            return Digits.few(Math.ceil(seconds)) + " s";
        }
        if (seconds < 6000) {
            return Digits.few(Math.ceil(seconds / 60)) + " min";
        }
        return seconds < 172_800 ? Digits.few(Math.ceil(seconds / 3600)) + " h"
                : Digits.few(Math.ceil(seconds / 86_400)) + " days";
    }

    /** Runs a scene for a short while. @param nanoTime a clock, such as {@link System#nanoTime} */
    static double seconds(Scene copy, double steps, LongSupplier nanoTime) {
        Stopwatch watch = new Stopwatch(steps, nanoTime);
        copy.simulation().addObserver(watch);
        try {
            copy.simulation().run();
        } catch (SimulationException | StoppedException e) {
            return watch.seconds;                           // what ends the run itself, it says for itself
        }
        return watch.seconds;
    }

    /**
     * Looks at the clock after every step, and ends the run when it has seen enough: each span is twice the one before.
     */
    private static final class Stopwatch implements Observer {
        private final double steps;
        private final LongSupplier nanoTime;
        private double seconds;
        private double span = FIRST_SPAN;
        private double begin;
        private long made;

        Stopwatch(double steps, LongSupplier nanoTime) {
            this.steps = steps;
            this.nanoTime = nanoTime;
            begin = nanoTime.getAsLong() * NANO;
        }

        @Override
        public void moved(Motion motion) {
            made++;
            double time = nanoTime.getAsLong() * NANO - begin;
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
