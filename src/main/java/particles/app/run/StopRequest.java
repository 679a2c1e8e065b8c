package particles.app.run;

import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.nio.charset.Charset;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import java.util.function.IntConsumer;
import java.util.function.Supplier;
import particles.Motion;
import particles.Observer;
import particles.app.cli.ExitCode;
import particles.output.files.OutputFolder;
import particles.output.files.StopHook;

/**
 * The end of the program by Ctrl-C or another signal: a line says so, processes that it started end with it, and
 * whatever was open tidies up by a {@link StopHook} of its own. Only a run that has begun is not cut off: it ends after
 * its step, completes its files and prints its summary, unless that takes too long.
 */
public final class StopRequest implements Observer {
    private static final long PATIENCE_SECONDS = 10;
    /** The time in which processes may tidy up (ms). */
    private static final long CHILDREN_MILLIS = 500;

    private final CountDownLatch ended = new CountDownLatch(1);
    /** Whether the process is ending: a command may fail for this reason before the hook has called request. */
    private final BooleanSupplier ending;
    private volatile boolean exits;                     // the command ends the process; no signal does
    private volatile boolean wanted;
    private volatile boolean endsByItself;
    private volatile Supplier<String> line = () -> "stopped";

    /** A stop of this process. */
    public StopRequest() {
        this(StopHook::isStopping);
    }

    StopRequest(BooleanSupplier ending) {
        this.ending = ending;
    }

    /**
     * Begins to listen to signals, once a process.
     *
     * @param err receives the line that says so
     */
    public void listen(OutputStream err) {
        PrintWriter lines = new PrintWriter(err, true, Charset.defaultCharset());
        Runtime.getRuntime().addShutdownHook(new Thread(() -> {
            if (stop(lines)) {
                endChildren();
            }
        }, "stop"));
    }

    /** @param line says what was stopped */
    public void setLine(Supplier<String> line) {
        this.line = line;
    }

    /**
     * What happens when the process ends, by a signal or by itself.
     *
     * @param err receives the line that says that the command was stopped
     * @return whether it was cut off
     */
    boolean stop(PrintWriter err) {
        if (exits) {                        // the command has ended by itself; there was no signal
            return false;
        }
        request();
        if (awaitEnd()) {
            return false;
        }
        err.println(line.get());            // even if it ends just now, because its files are taken from it
        return true;
    }

    private static void endChildren() {
        List<ProcessHandle> children = ProcessHandle.current().descendants().toList();
        children.forEach(ProcessHandle::destroy);
        CompletableFuture.allOf(children.stream().map(ProcessHandle::onExit).toArray(CompletableFuture<?>[]::new))
                .completeOnTimeout(null, CHILDREN_MILLIS, TimeUnit.MILLISECONDS).join();
        children.forEach(ProcessHandle::destroyForcibly);
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

    /**
     * From now on, a stop lets the command end by itself.
     *
     * @param folder its results
     */
    void letEnd(OutputFolder folder) {
        endsByItself = true;
        folder.setWhenStopped(this::awaitEnd);
    }

    /** Waits for a command that ends by itself; returns whether it did in time. */
    private boolean awaitEnd() {
        try {
            if (endsByItself && !ended.await(PATIENCE_SECONDS, TimeUnit.SECONDS)) {
                endsByItself = false;
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        return endsByItself;
    }

    /**
     * Ends the process. If a signal is already ending it, that continues, so that the exit code is the signal's, such
     * as 143 for SIGTERM.
     *
     * @param code the exit code
     * @param exit ends the process with a number, as {@link System#exit} does
     */
    public void end(ExitCode code, IntConsumer exit) {
        exits = !wanted && !ending.getAsBoolean();
        ended.countDown();
        if (exits) {
            exit.accept(code.code());
        }
    }

    /** @return the stream, until the command is cut off: what it says then is of a program that falls apart */
    public OutputStream untilCutOff(OutputStream stream) {
        return new FilterOutputStream(stream) {
            @Override
            public void write(byte[] bytes, int offset, int length) throws IOException {
                if (endsByItself || !StopHook.isStopping()) {
                    out.write(bytes, offset, length);
                }
            }
        };
    }
}
