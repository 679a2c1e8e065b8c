package particles.output.files;

import java.util.concurrent.CancellationException;

/**
 * Tidies up if the program is stopped, by Ctrl-C or another signal, while something is unfinished. Java then runs the
 * hooks of all that is still open at once, each in a thread of its own, and ends when all are done.
 */
public final class StopHook implements AutoCloseable {
    private final Tidying hook;

    /**
     * @param tidy removes what must not be left over; other threads go on meanwhile
     * @throws CancellationException if the program is being stopped: then only a hook may begin something new
     */
    public StopHook(Runnable tidy) {
        hook = new Tidying(tidy);
        if (!added() && !(Thread.currentThread() instanceof Tidying)) {
            throw new CancellationException("the program is being stopped");
        }
    }

    /** @return whether the program is being stopped */
    public static boolean isStopping() {
        try {
            new StopHook(() -> { }).close();
            return false;
        } catch (CancellationException e) {
            return true;
        }
    }

    private static final class Tidying extends Thread {
        Tidying(Runnable tidy) {
            super(tidy, "stop");
        }
    }

    private boolean added() {
        try {
            Runtime.getRuntime().addShutdownHook(hook);
            return true;
        } catch (IllegalStateException e) {             // there is no other way to ask
            return false;
        }
    }

    /** Forgets the hook, as there is nothing left to tidy; while the program is being stopped, it runs all the same. */
    @Override
    public void close() {
        try {
            Runtime.getRuntime().removeShutdownHook(hook);
        } catch (IllegalStateException e) {
            return;
        }
    }
}
