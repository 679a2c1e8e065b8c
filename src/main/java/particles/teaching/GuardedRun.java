package particles.teaching;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.atomic.AtomicReference;
import particles.teaching.Finding.Kind;

/**
 * Runs a student's class in a thread of its own with a time limit, and reports an endless loop, a stack overflow or a
 * lack of memory. The limit is on CPU time, so that a busy machine makes no loop endless. It does not protect from
 * {@code System.exit}; only a separate process does.
 */
public final class GuardedRun {
    /**
     * The limit of elapsed time, as a multiple of that of CPU time: on a busy machine a loop gets only a part of the
     * processor.
     */
    private static final double BUSY_MACHINE = 50;
    private static final double NANOS = 1e9;
    private static final long POLL_MILLIS = 20;

    private final double seconds;
    private final AtomicReference<Thread> running = new AtomicReference<>();

    /** @param seconds the CPU time allowed (s); three times as much is allowed for waiting */
    public GuardedRun(double seconds) {
        this.seconds = seconds;
    }

    /**
     * The outcome of a run.
     *
     * @param value   the result, if there is one
     * @param failure the failure, if there is one
     */
    public record Outcome<T>(Optional<T> value, Optional<Finding> failure) {
    }

    /**
     * Runs the code. A thread that does not end is interrupted and abandoned; it does not keep the program alive.
     *
     * @param what the code to run
     * @return the outcome
     */
    public <T> Outcome<T> run(Callable<T> what) {
        AtomicReference<T> value = new AtomicReference<>();
        AtomicReference<Throwable> thrown = new AtomicReference<>();
        Thread thread = new Thread(() -> {
            try {
                value.set(what.call());
            } catch (Throwable t) {
                thrown.set(t);
            }
        }, "check");
        thread.setDaemon(true);
        running.set(thread);
        thread.start();
        Optional<Finding> stuck = await(thread);
        if (stuck.isPresent()) {
            return new Outcome<>(Optional.empty(), stuck);
        }
        running.set(null);
        return thrown.get() == null ? new Outcome<>(Optional.of(value.get()), Optional.empty())
                : new Outcome<>(Optional.empty(), Optional.of(failure(thrown.get())));
    }

    private Optional<Finding> await(Thread thread) {
        ThreadMXBean threads = ManagementFactory.getThreadMXBean();
        long start = System.nanoTime();
        while (thread.isAlive()) {
            try {
                thread.join(POLL_MILLIS);
            } catch (InterruptedException e) {
                thread.interrupt();
                Thread.currentThread().interrupt();
                return Optional.of(new Finding(Kind.FAILURE, "the check was interrupted"));
            }
            double computed = threads.getThreadCpuTime(thread.getId()) / NANOS;     // negative once it has ended
            double elapsed = (System.nanoTime() - start) / NANOS;
            boolean waits = thread.getState() != Thread.State.RUNNABLE && elapsed > 3 * seconds;
            if (computed > seconds || waits || elapsed > BUSY_MACHINE * seconds) {
                String place = StudentFailure.place(thread.getStackTrace());
                thread.interrupt();
                return Optional.of(new Finding(Kind.FAILURE, "it did not come back within " + Formula.number(seconds)
                        + " s: "
                        + (waits ? "it waits for something that never comes" : "an endless loop") + place));
            }
        }
        return Optional.empty();
    }

    private static Finding failure(Throwable thrown) {
        String place = StudentFailure.place(thrown.getStackTrace());
        if (thrown instanceof StackOverflowError) {
            return new Finding(Kind.FAILURE, "the stack overflows: a method calls itself without end" + place);
        }
        if (thrown instanceof OutOfMemoryError) {
            return new Finding(Kind.FAILURE, "it asks for more memory than the " + Runtime.getRuntime()
                    .maxMemory() / (1 << 20)
                    + " MB that there are" + place);
        }
        return new Finding(Kind.FAILURE, "it ends in an exception: " + StudentFailure.describe(thrown));
    }

    /**
     * @return the line that the student's class executes now, if it is running; for a shutdown hook
     */
    public Optional<String> runningAt() {
        return Optional.ofNullable(running.get()).map(thread -> StudentFailure.place(thread.getStackTrace()));
    }
}
