package particles.app.run;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.IntConsumer;
import particles.app.cli.ExitCode;

/**
 * The wish that the program ends early, by Ctrl-C or a signal. A run that hears of it completes its files and ends; one
 * that does not hear of it in time loses what is not complete, so that in any case whole files are left, and no others.
 */
public final class StopRequest {
    private static final long PATIENCE_SECONDS = 10;

    private final CountDownLatch ended = new CountDownLatch(1);
    private final List<Runnable> lastResorts = new ArrayList<>();
    private volatile boolean wanted;

    /** From now on this process hears of signals that end it. Once a process. */
    public void listen() {
        Runtime.getRuntime().addShutdownHook(new Thread(this::stopAndWait, "stop"));
    }

    /** Asks for the end. */
    void request() {
        wanted = true;
    }

    /** @return whether the end was asked for */
    boolean isWanted() {
        return wanted;
    }

    /** @param action what to do if the program has not ended in time; called by another thread */
    synchronized void addLastResort(Runnable action) {
        lastResorts.add(action);
    }

    /**
     * The program has done all that it wanted to do. Where a signal is ending the process, that goes on, with the
     * signal's exit code, such as 143 of SIGTERM: Java would take another code that came at the last moment.
     *
     * @param code how it ended
     * @param exit ends the process with a number, as {@link System#exit} does
     */
    public void end(ExitCode code, IntConsumer exit) {
        boolean signalled = wanted;
        ended.countDown();
        if (!signalled) {
            exit.accept(code.code());
        }
    }

    private void stopAndWait() {
        request();
        try {
            if (ended.await(PATIENCE_SECONDS, TimeUnit.SECONDS)) {
                return;
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        synchronized (this) {
            lastResorts.forEach(Runnable::run);
        }
    }
}
