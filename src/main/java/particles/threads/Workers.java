package particles.threads;

import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;

/**
 * A few threads that do a piece of work together with the thread that asks for it, over and over and without
 * allocating. Between two pieces they watch for the next one for a while, and then sleep until they are woken. They are
 * daemons, and end when they are closed.
 */
final class Workers implements AutoCloseable {
    /**
     * How often a thread looks before it sleeps, where each has a processor: one or two milliseconds, longer than a
     * solver's own arithmetic takes. To wake a thread costs up to a tenth of one: with a fortieth of the looks two
     * threads were slower than one on a cloth of 64 x 64, and with these they take two thirds of its time.
     */
    private static final int LOOKS = 40_000;
    /** Where threads share a processor, looking keeps the other from working. */
    private static final int FEW_LOOKS = 500;
    /**
     * After so many looks, some microseconds, each further one lets others have the processor first: the thread that is
     * waited for may have none, as something else runs on the machine, if only the drawing of frames. That cloth took
     * two threads four times as long as one then, and takes them as long with this.
     */
    private static final int LOOKS_ALONE = 100;
    /** So many looks take as long as one that lets others go first. */
    private static final int LOOKS_OF_A_YIELD = 10;

    /** What is done together. */
    interface Work {
        /**
         * @param part  which part of it, from 0
         * @param parts how many parts there are, done by as many threads
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
    private Work work;                                  // handed over by round

    /** @param threads how many work together, the caller's own included; 2 or more */
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

    /** How many threads work together, the caller's own included. */
    int count() {
        return helpers.length + 1;
    }

    /** Does all parts of the work, part 0 in this thread; a failure of any of them is thrown when all have ended. */
    void run(Work work) {
        this.work = work;
        caller = Thread.currentThread();
        failure = null;                                 // last time the caller's own may have been thrown instead
        busy.set(helpers.length);
        round++;                                        // only the caller writes it
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

    /** Waits for a moment, as long as is right after so many looks; returns how many there are then. */
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

    /** Ends the threads, and waits until they have ended. */
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
                    interrupted = true;                 // they are about to end in any case
                }
            }
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }
}
