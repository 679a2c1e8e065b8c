package particles.output.frames;

import java.util.Queue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Semaphore;
import java.util.function.Function;
import java.util.function.Supplier;

/**
 * Runs tasks on several threads, and the last part of each in the order in which they were added. A few tasks may wait;
 * then the caller waits. After a failure no task begins; to add one throws the failure, and so does {@link #close} if
 * none was added.
 *
 * @param <T> a tool that tasks use, one at a time, such as a picture to draw on
 */
public final class Pipeline<T> implements AutoCloseable {
    /** The number of tasks that may wait besides those being run. */
    private static final int WAITING = 2;
    /** The part of the free memory that more than one tool may take. */
    private static final int MEMORY_SHARE = 4;

    private final Supplier<T> tools;
    private final Queue<T> idle = new ConcurrentLinkedQueue<>();
    private final ExecutorService threads;
    private final Semaphore room;
    private CompletableFuture<Void> last = CompletableFuture.completedFuture(null);
    private volatile boolean failed;
    private boolean reported;

    /**
     * @param threads the number of threads
     * @param tools   makes a tool, at most one for each thread
     */
    public Pipeline(int threads, Supplier<T> tools) {
        this.tools = tools;
        room = new Semaphore(threads + WAITING);
        this.threads = Executors.newFixedThreadPool(threads, task -> {
            Thread thread = new Thread(task, "frames");
            thread.setDaemon(true);         // a program that ends does not wait for pictures
            return thread;
        });
    }

    /**
     * @param bytes the memory of a tool
     * @return a thread for each processor, or fewer if memory is short
     */
    public static int threads(long bytes) {
        Runtime java = Runtime.getRuntime();
        long free = java.maxMemory() - java.totalMemory() + java.freeMemory();
        return (int) Math.max(1, Math.min(java.availableProcessors(), free / MEMORY_SHARE / bytes));
    }

    /**
     * Adds a task, when there is room for it.
     *
     * @param task does the first part with a tool, and returns the rest; the tool is the task's until both are done
     * @return is complete when the task is done; it fails with it, or with an earlier one
     */
    public CompletableFuture<Void> add(Function<T, Runnable> task) {
        if (failed) {
            awaitLast();
        }
        room.acquireUninterruptibly();
        CompletableFuture<Void> earlier = last;
        last = CompletableFuture.runAsync(() -> run(task, earlier), threads);
        return last.whenComplete((done, failure) -> {
            if (failure != null) {
                failed = true;
            }
            room.release();
        });
    }

    private void run(Function<T, Runnable> task, CompletableFuture<Void> earlier) {
        if (failed) {
            earlier.join();             // throws the failure, before a frame is drawn that nobody will see
        }
        T tool = idle.poll();
        Runnable rest;
        try {
            tool = tool == null ? tools.get() : tool;
            rest = task.apply(tool);
        } catch (RuntimeException | Error e) {
            rest = () -> {
                throw e;                // in its turn: the failure of an earlier task comes first
            };
        }
        earlier.join();
        rest.run();
        idle.add(tool);
    }

    /** Waits until all tasks are done, and ends the threads. */
    @Override
    public void close() {
        threads.shutdown();
        if (!reported) {
            awaitLast();
        }
    }

    /** Waits for the last task, and throws a failure, which the close that follows must not throw again. */
    private void awaitLast() {
        try {
            last.join();
        } catch (CompletionException e) {
            reported = true;
            if (e.getCause() instanceof Error error) {
                throw error;
            }
            throw (RuntimeException) e.getCause();      // nothing here throws a checked one
        }
    }
}
