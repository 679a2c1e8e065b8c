package particles.threads;

import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;

/**
 * A small thread pool that repeatedly runs the parts of a task together with the calling thread, without allocating.
 * Between tasks the threads spin for a while, then park. They are daemon threads and end on close.
 */
final class Workers implements AutoCloseable {
    /**
     * Spins before a thread parks, if each has a processor: one or two milliseconds, longer than a solver's own
     * arithmetic takes, as waking a thread may take longer than its part of a cloth's forces.
     */
    private static final int LOOKS = 40_000;
    /** Spins if threads share a processor, where spinning keeps the other thread from working. */
    private static final int FEW_LOOKS = 500;
    /**
     * After this number of spins, some microseconds, each further one yields the processor, which the other thread may
     * need while something else runs, such as the drawing of frames.
     */
    private static final int LOOKS_ALONE = 100;
    /** A yield takes as long as this many spins. */
    private static final int LOOKS_OF_A_YIELD = 10;

    /** A task made of parts. */
    interface Work {
        /**
         * @param part  index of the part, from 0
         * @param parts the number of parts and of threads
         */
        void run(int part, int parts);
    }

    private final Thread[] helpers;
    private final int looks;
    private final AtomicInteger busy = new AtomicInteger();
    private volatile int round;
    private volatile boolean closed;
    private volatile Throwable failure;
    private volatile Thread caller;
    private Work work;                                  // published by the write to round

    /** @param threads the number of threads, including the caller's; 2 or more */
    Workers(int threads) {
        helpers = new Thread[threads - 1];
        looks = threads <= Runtime.getRuntime().availableProcessors() ? LOOKS : FEW_LOOKS;
        for (int h = 0; h < helpers.length; h++) {
            int part = h + 1;
            helpers[h] = new Thread(() -> help(part), "forces-" + part);
            helpers[h].setDaemon(true);
            helpers[h].start();
        }
    }

    /** The number of threads, including the caller's. */
    int count() {
        return helpers.length + 1;
    }

    /** Runs all parts, part 0 in this thread; an exception of any part is thrown when all have ended. */
    void run(Work work) {
        this.work = work;
        caller = Thread.currentThread();
        failure = null;                                 // an old one may remain if the caller's part failed too
        busy.set(helpers.length);
        round++;                                        // only the caller writes round
        for (Thread helper : helpers) {
            LockSupport.unpark(helper);
        }
        try {
            work.run(0, helpers.length + 1);
        } finally {
            waitForHelpers();
        }
        Throwable thrown = failure;
        if (thrown != null) {
            if (thrown instanceof Error) {
                throw (Error) thrown;
            }
            throw (RuntimeException) thrown;
        }
    }

    private void waitForHelpers() {
        for (int look = 0; busy.get() > 0; ) {
            look = waited(look);
        }
    }

    /** Spins, yields or parks, depending on the number of spins so far; returns their new number. */
    private int waited(int look) {
        if (look < Math.min(LOOKS_ALONE, looks)) {
            Thread.onSpinWait();
            return look + 1;
        }
        if (look < looks) {
            Thread.yield();
            return look + LOOKS_OF_A_YIELD;
        }
        LockSupport.park(this);
        return look;
    }

    private void help(int part) {
        int done = 0;
        for (int look = 0; !closed; ) {
            if (round == done) {
                look = waited(look);
                continue;
            }
            done++;
            look = 0;
            try {
                work.run(part, helpers.length + 1);
            } catch (RuntimeException | Error e) {
                failure = e;
            }
            if (busy.decrementAndGet() == 0) {
                LockSupport.unpark(caller);
            }
        }
    }

    /** Ends the threads and waits for them. */
    @Override
    public void close() {
        closed = true;
        boolean interrupted = false;
        for (Thread helper : helpers) {
            LockSupport.unpark(helper);
            while (helper.isAlive()) {
                try {
                    helper.join();
                } catch (InterruptedException e) {
                    interrupted = true;                 // the threads end in any case
                }
            }
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }
}
