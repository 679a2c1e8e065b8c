package particles.app.cli;

import java.io.PrintWriter;
import java.util.function.LongSupplier;
import particles.experiments.runs.ProgressListener;

/**
 * Prints the progress of an experiment and the remaining time: at most one line every two seconds, none for short
 * experiments.
 */
public final class PrintedProgress implements ProgressListener {
    private static final double NANO = 1e-9;
    private static final double PAUSE = 2;
    /** Before this part is done, the remaining time cannot be estimated. */
    private static final double EARLY = 0.1;
    /** Shorter remaining times (s) are not printed. */
    private static final double SHORT = 10;

    private final PrintWriter out;
    private final LongSupplier nanoTime;
    private final boolean timed;
    private final long begin;
    private long last;

    /**
     * @param out      the output
     * @param nanoTime a clock, such as {@link System#nanoTime}
     */
    public PrintedProgress(PrintWriter out, LongSupplier nanoTime) {
        this(out, nanoTime, true);
    }

    /** @param timed whether the parts are in proportion to their times, so that the remaining time can be told */
    public PrintedProgress(PrintWriter out, LongSupplier nanoTime, boolean timed) {
        this.out = out;
        this.nanoTime = nanoTime;
        this.timed = timed;
        begin = nanoTime.getAsLong();
        last = begin;
    }

    @Override
    public void reached(double part, String what) {
        long now = nanoTime.getAsLong();
        if ((now - last) * NANO >= PAUSE) {
            double left = (now - begin) * NANO * (1 - part) / part;
            out.println((int) (100 * part) + " %" + (!timed || part < EARLY || left < SHORT ? "" : ", about "
                    + 5 * Math.round(left / 5) + " s left") + ": " + what);
            last = now;
        }
    }
}
