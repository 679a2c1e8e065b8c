package particles.teaching;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicReference;
import particles.teaching.Finding.Kind;

/**
 * Runs a student's class in a thread of its own and reports an endless loop, a stack overflow or a lack of memory. Only
 * the CPU time of that thread, or of one that it awaits, since the last {@link #goesOn} tells that a loop does not end,
 * so that neither a busy machine nor a costly class makes one endless; a run that takes too long in all is not decided.
 * It does not protect from {@code System.exit}; only a separate process does.
 */
public final class GuardedRun {
    /** The elapsed time after which a run is not decided, as a multiple of the CPU time allowed to a step. */
    private static final double GIVE_UP = 100;
    /** The same for its CPU time: with 7 s for a step, 63 s in all. */
    private static final double COSTLY = 9;
    private static final double NANOS = 1e9;
    private static final long POLL_MILLIS = 20;
    /** So many looks at a thread that waits and computes nothing tell that it waits for ever; fewer below a second. */
    private static final int WAITS = 100;
    private static final Set<Thread.State> IDLE = EnumSet.of(Thread.State.BLOCKED, Thread.State.WAITING,
            Thread.State.TIMED_WAITING);
    /** The run of this thread, or of the one that started it. */
    private static final InheritableThreadLocal<GuardedRun> RUN = new InheritableThreadLocal<>();

    private final double seconds;
    private final AtomicReference<Thread> running = new AtomicReference<>();
    /** The number of steps that came back. */
    private final AtomicLong done = new AtomicLong();

    /** Tells, within a run, that a step came back. */
    public static void goesOn() {
        Optional.ofNullable(RUN.get()).ifPresent(run -> run.done.incrementAndGet());    // null outside of a run
    }

    /** Starts another thread within a run and waits for it; until it ends, its CPU time counts and not this one's. */
    public static void await(Thread other) {
        AtomicReference<Thread> running = RUN.get().running;
        Thread self = running.getAndSet(other);
        other.setDaemon(true);
        other.start();
        try {
            other.join();
        } catch (InterruptedException e) {
            self.interrupt();
        }
        running.set(self);
    }

    /** @param seconds the CPU time allowed to a step (s) */
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
            RUN.set(this);
            try {
                value.set(what.call());
            } catch (Throwable t) {
                thrown.set(t);
            }
        }, "check");
        thread.setDaemon(true);
        running.set(thread);
        thread.start();
        Optional<Finding> stuck = watch(thread);
        if (stuck.isPresent()) {
            return new Outcome<>(Optional.empty(), stuck);
        }
        running.set(null);
        return thrown.get() == null ? new Outcome<>(Optional.of(value.get()), Optional.empty())
                : new Outcome<>(Optional.empty(), Optional.of(failure(thrown.get())));
    }

    private Optional<Finding> watch(Thread thread) {
        ThreadMXBean threads = ManagementFactory.getThreadMXBean();
        long start = System.nanoTime();
        Thread last = thread;
        double before = 0;
        double begun = 0;
        long steps = 0;
        int waited = 0;
        double waits = WAITS * Math.min(1, seconds);
        while (thread.isAlive()) {
            try {
                thread.join(POLL_MILLIS);
            } catch (InterruptedException e) {
                thread.interrupt();
                Thread.currentThread().interrupt();
                return Optional.of(new Finding(Kind.UNDECIDED, "the check was interrupted"));
            }
            Thread now = running.get();
            double computed = threads.getThreadCpuTime(now.getId()) / NANOS;        // negative once it has ended
            waited = IDLE.contains(now.getState()) && computed == before ? waited + 1 : 0;
            before = computed;
            begun = done.get() == steps && now == last ? begun : computed;
            last = now;
            steps = done.get();
            double elapsed = (System.nanoTime() - start) / NANOS;
            if (thread.isAlive() && (computed - begun > seconds || waited > waits || computed > COSTLY * seconds
                    || elapsed > GIVE_UP * seconds)) {
                String place = StudentFailure.place(now.getStackTrace());
                now.interrupt();
                boolean busy = computed - begun <= seconds && waited <= waits;
                return Optional.of(new Finding(busy ? Kind.UNDECIDED : Kind.FAILURE, (busy ? Formula.text("%s s of CPU"
                        + " time in %s s were too little for all steps: make a step cheaper, or run it again on a"
                        + " machine that is less busy", computed, elapsed) : Formula.text("it did not come back within"
                        + " %s s of CPU time: %s", seconds, computed - begun > seconds ? "an endless loop"
                        : "it waits for something that never comes")) + place));
            }
        }
        return Optional.empty();
    }

    private static Finding failure(Throwable thrown) {
        String text = thrown instanceof EndlessLoop ? "it did not come back: an endless loop, as " + thrown.getMessage()
                : thrown instanceof StackOverflowError ? "the stack overflows: a method calls itself without end"
                : thrown instanceof OutOfMemoryError ? "it asks for more memory than the " + Runtime.getRuntime()
                .maxMemory() / (1 << 20) + " MB that there are" : "it ends in an exception: " + thrown;
        return new Finding(Kind.FAILURE, text + StudentFailure.place(thrown.getStackTrace()));
    }

    /**
     * @return the line of the student's class that ends the whole program, if one does; for a shutdown hook, which also
     *         runs when a signal ends the program
     */
    public Optional<String> endedAt() {
        return running.get() == null ? Optional.empty()         // null when the class is not running
                : Thread.getAllStackTraces().values().stream().filter(calls -> Arrays.stream(calls).anyMatch(call ->
                call.getClassName().equals(Runtime.class.getName()) && call.getMethodName().equals("exit")))
                .findFirst().map(StudentFailure::place);
    }

    /** Ends a student's loop that does not end by itself; an error, as no class that swallows exceptions may go on. */
    public static final class EndlessLoop extends Error {
        private static final long serialVersionUID = 1L;

        /** @param how how it shows, such as the number of calls */
        public EndlessLoop(String how) {
            super(how);
        }
    }
}
