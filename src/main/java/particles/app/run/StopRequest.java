package particles.app.run;

import java.util.concurrent.CancellationException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.IntConsumer;
import particles.Motion;
import particles.Observer;
import particles.app.cli.ExitCode;

/**
 * A request to stop the program early, by Ctrl-C or a signal. The run completes its files and ends; if it takes too
 * long, incomplete files are deleted, so only whole files are left.
 */
public final class StopRequest implements Observer {
    private static final long PATIENCE_SECONDS = 10;

    private final CountDownLatch ended = new CountDownLatch(1);
    private volatile Runnable lastResort = () -> { };
    private volatile boolean wanted;

    /** Installs the signal handler, once a process. */
    public void listen() {
        Runtime.getRuntime().addShutdownHook(new Thread(this::stopAndWait, "stop"));
    }

    /** @return whether the stop was requested */
    boolean isWanted() {
        return wanted;
    }

    /** Requests the stop. */
    void request() {
        wanted = true;
    }

    /** Ends a run after the step in which a stop was requested; as the last observer, so that others saw the step. */
    @Override
    public void moved(Motion motion) {
        if (wanted) {
            throw new CancellationException("the run was stopped");
        }
    }

    /** @param action called by another thread if the program has not ended in time */
    void setLastResort(Runnable action) {
        lastResort = action;
    }

    /**
     * Ends the process. If a signal is already ending it, that continues, so that the exit code is the signal's, such
     * as 143 for SIGTERM.
     *
     * @param code the exit code
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
        lastResort.run();
    }
}
