package particles.engine;

import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.LockSupport;
import java.util.function.IntConsumer;
import java.util.stream.Stream;

/**
 * Work in pieces, done by the calling thread and by helpers, threads of the common pool. The caller takes pieces from
 * the first on, helpers from the last on, so that each mostly finds its own part of the arrays in its cache. The caller
 * waits for pieces that a helper has taken, and never for a helper itself: if none comes, it does everything.
 *
 * <p>Waking a thread takes as long as evaluating some thousand springs. So a helper stays, and spins, for a while after
 * the last piece, and a caller that waits spins too before it sleeps.
 */
final class SharedWork {
    /** How long a helper looks for work before it leaves (ns). */
    private static final long STAY = 100_000;
    /** The caller waits as long as it worked itself, and so much longer, before it sleeps (ns). */
    private static final long PATIENCE = 50_000;
    private static final long SLEEP = 50_000;
    /** A thread that waits offers its processor to others after this time (ns). */
    private static final long SPIN = 10_000;
    private static final int FIRST = 1;
    private static final int LAST = 1 << 8;
    private static final int PIECES = 1 << 16;
    private static final long RUN = 1 << 24;

    /** The number of the run, its pieces, and how many are taken from the last and from the first on. */
    private final AtomicLong taken = new AtomicLong();
    private final AtomicInteger done = new AtomicInteger();
    private final Helper[] helpers;
    private IntConsumer work;
    private volatile Throwable failure;
    private long delay;

    SharedWork(int helpers) {
        this.helpers = Stream.generate(Helper::new).limit(helpers).toArray(Helper[]::new);
    }

    /** Calls the helpers that have left. */
    void begin() {
        delay = 0;
        for (Helper helper : helpers) {
            if (!helper.here) {
                helper.here = true;
                ForkJoinPool.commonPool().execute(helper);
            }
        }
    }

    /** @return how long helpers have kept the caller waiting since {@link #begin}, beyond its patience (ns) */
    long getDelay() {
        return delay;
    }

    /**
     * Does the work on all pieces, at most 255. An exception in any thread is thrown, as it is, when all have ended.
     */
    void run(int pieces, IntConsumer work) {
        this.work = work;
        failure = null;
        done.set(0);
        long start = System.nanoTime();
        taken.set((taken.get() / RUN + 1) * RUN + (long) pieces * PIECES);      // from here on, helpers may begin
        while (takePiece(FIRST)) {
            continue;
        }
        if (done.get() < pieces) {
            await(pieces, start);
        }
        if (failure instanceof Error error) {
            throw error;
        } else if (failure != null) {
            throw (RuntimeException) failure;
        }
    }

    private void await(int pieces, long start) {
        long now = System.nanoTime();
        long latest = now + (now - start) + PATIENCE;
        for (long time = now; done.get() < pieces && time < latest; time = System.nanoTime()) {
            spin(time - now);
        }
        if (done.get() < pieces) {
            while (done.get() < pieces) {
                LockSupport.parkNanos(SLEEP);
            }
            delay += System.nanoTime() - now;
        }
    }

    /** Spins at first, then yields the processor to other threads. */
    @SuppressWarnings("ThreadPriorityCheck")            // results never depend on who runs when
    private static void spin(long waited) {
        if (waited < SPIN) {
            Thread.onSpinWait();
        } else {
            Thread.yield();
        }
    }

    /** Takes and does a piece, the first or the last one left; returns false if none is left. */
    private boolean takePiece(int end) {
        while (true) {
            long before = taken.get();
            int pieces = (int) (before / PIECES & 255);
            int last = (int) (before / LAST & 255);
            int first = (int) (before & 255);
            if (first + last >= pieces) {
                return false;
            }
            if (taken.compareAndSet(before, before + end)) {        // fails if a new run has begun
                try {
                    work.accept(end == FIRST ? first : pieces - 1 - last);
                } catch (RuntimeException | Error e) {
                    failure = e;
                }
                done.incrementAndGet();
                return true;
            }
        }
    }

    /** A task for the pool. */
    private final class Helper implements Runnable {
        private volatile boolean here;

        @Override
        public void run() {
            long start = System.nanoTime();             // of the wait for a piece
            for (long time = start; time - start < STAY; time = System.nanoTime()) {
                if (takePiece(LAST)) {
                    start = System.nanoTime();
                } else {
                    spin(time - start);
                }
            }
            here = false;
        }
    }
}
