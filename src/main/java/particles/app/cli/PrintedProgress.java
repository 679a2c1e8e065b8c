package particles.app.cli;

import java.io.PrintWriter;
import java.util.function.LongSupplier;
import particles.experiments.runs.ProgressListener;

/** Prints the progress of an experiment: at most one line every two seconds, none for short experiments. */
public final class PrintedProgress implements ProgressListener {
    private static final double NANO = 1e-9;
    private static final double PAUSE = 2;

    private final PrintWriter out;
    private final LongSupplier nanoTime;
    private long last;

    /**
     * @param out      the output
     * @param nanoTime a clock, such as {@link System#nanoTime}
     */
    public PrintedProgress(PrintWriter out, LongSupplier nanoTime) {
        this.out = out;
        this.nanoTime = nanoTime;
        last = nanoTime.getAsLong();
    }

    @Override
    public void reached(double part, String what) {
        long now = nanoTime.getAsLong();
        if ((now - last) * NANO >= PAUSE) {
            out.println((int) (100 * part) + " %: " + what);
            last = now;
        }
    }
}
