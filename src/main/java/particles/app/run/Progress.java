package particles.app.run;

import deSolvers.text.Digits;
import java.io.PrintWriter;
import java.util.function.LongSupplier;
import particles.Motion;
import particles.Observer;

/** Prints the progress of a long run: at most one line a second, none for short runs. */
final class Progress implements Observer {
    private static final double NANO = 1e-9;
    /** Runs shorter than this print nothing (s). */
    private static final double SILENCE = 2;
    /** The least time between two lines (s). */
    private static final double PAUSE = 1;
    /** A line is printed after this fraction of the run, or after a longer time (s). */
    private static final double NEWS = 0.1;
    private static final double LONG_PAUSE = 10;

    private final PrintWriter out;
    private final double duration;
    private final LongSupplier nanoTime;
    private final long begin;
    private double lastTime;
    private double lastPart;

    /**
     * @param out      the output
     * @param duration the duration of the run (s)
     * @param nanoTime a clock, such as {@link System#nanoTime}
     */
    Progress(PrintWriter out, double duration, LongSupplier nanoTime) {
        this.out = out;
        this.duration = duration;
        this.nanoTime = nanoTime;
        begin = nanoTime.getAsLong();
    }

    /** @return the time since the beginning (s) */
    double seconds() {
        return (nanoTime.getAsLong() - begin) * NANO;
    }

    @Override
    public void moved(Motion motion) {
        double seconds = seconds();
        if (seconds < SILENCE || seconds - lastTime < PAUSE) {
            return;
        }
        double part = motion.getEndTime() / duration;
        if (part < 1 && (part - lastPart >= NEWS || seconds - lastTime >= LONG_PAUSE)) {
            out.println("t = " + Digits.few(motion.getEndTime()) + " s of " + Digits.few(duration) + " s, "
                    + (int) (100 * part) + " %, about "
                    + Digits.few(Math.ceil(seconds * (1 - part) / part)) + " s to go");
            out.flush();
            lastTime = seconds;
            lastPart = part;
        }
    }
}
