package particles.output.frames;

import java.util.List;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import particles.output.painters.FrameState;

/**
 * Draws and writes frames on a thread of its own, beside the simulation. A few copies of states are exchanged between
 * the two; when all are waiting to be drawn, the simulation waits. Failures on the thread are thrown to the next
 * caller.
 */
final class FrameWorker implements AutoCloseable {
    private static final int STATES = 3;

    private static final Runnable END = () -> { };

    private final FrameRenderer renderer;
    private final List<FrameSink> sinks;
    private final BlockingQueue<FrameState> free = new ArrayBlockingQueue<>(STATES);
    private final BlockingQueue<Runnable> waiting = new ArrayBlockingQueue<>(STATES + 1);
    private final Thread thread;
    private volatile Throwable failure;
    private boolean reported;
    private boolean closed;

    FrameWorker(FrameRenderer renderer, List<FrameSink> sinks) {
        this.renderer = renderer;
        this.sinks = List.copyOf(sinks);
        for (int k = 0; k < STATES; k++) {
            free.add(new FrameState());
        }
        thread = new Thread(this::work, "frames");
        thread.setDaemon(true);         // a program that ends does not wait for pictures
        thread.start();
    }

    /** @return a state to be filled and handed back by {@link #draw}; waiting for it keeps the queue short */
    FrameState next() {
        reportFailure();
        try {
            return free.take();
        } catch (InterruptedException e) {
            throw interrupted(e);
        }
    }

    /** @param times the number of frames that show the picture, from frame index on */
    void draw(int index, FrameState state, int times) {
        waiting.add(() -> {
            if (failure == null) {
                attempt(() -> render(index, state, times));
            }
            free.add(state);
        });
    }

    /** Waits until all frames are drawn and written. */
    @Override
    public void close() {
        if (closed) {
            return;
        }
        closed = true;
        waiting.add(END);
        try {
            thread.join();
        } catch (InterruptedException e) {
            throw interrupted(e);
        }
        reportFailure();
    }

    private static IllegalStateException interrupted(InterruptedException e) {
        Thread.currentThread().interrupt();
        return new IllegalStateException("interrupted while frames were being drawn", e);
    }

    /** Throws a failure, once only: the close that follows must not throw it again. */
    private void reportFailure() {
        Throwable problem = failure;
        if (problem == null || reported) {
            return;
        }
        reported = true;
        if (problem instanceof Error error) {
            throw error;
        }
        throw (RuntimeException) problem;       // nothing here throws a checked one
    }

    private void work() {
        try {
            for (Runnable job = waiting.take(); job != END; job = waiting.take()) {
                job.run();
            }
        } catch (InterruptedException e) {
            failure = interrupted(e);
        }
        for (FrameSink sink : sinks) {
            attempt(sink::close);
        }
    }

    private void render(int index, FrameState state, int times) {
        int[] rgb = renderer.render(state);
        for (int k = 0; k < times; k++) {
            for (FrameSink sink : sinks) {
                sink.add(index + k, rgb);
            }
        }
    }

    /** Runs an action and keeps any failure, out of memory included, for the thread that can end the run. */
    private void attempt(Runnable action) {
        try {
            action.run();
        } catch (RuntimeException | Error e) {
            if (failure == null) {
                failure = e;
            } else {
                failure.addSuppressed(e);
            }
        }
    }
}
