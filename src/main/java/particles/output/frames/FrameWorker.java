package particles.output.frames;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import particles.output.painters.FrameState;

/** Draws frames on threads of their own, beside the simulation, and passes them on in order. */
final class FrameWorker implements AutoCloseable {
    private final List<FrameSink> sinks;
    private final Pipeline<FrameRenderer> pipeline;
    private CompletableFuture<Boolean> strainSeen = CompletableFuture.completedFuture(false);
    private FrameState opening;
    private boolean closed;

    FrameWorker(FrameRenderer renderer, List<FrameSink> sinks, int threads) {
        this.sinks = List.copyOf(sinks);
        pipeline = new Pipeline<>(threads, () -> renderer.another(opening));
    }

    /** @param times the number of frames that show the picture, from frame index on */
    void draw(int index, FrameState state, int times) {
        if (opening == null) {
            opening = state;
        }
        CompletableFuture<Boolean> before = strainSeen;
        CompletableFuture<Boolean> now = new CompletableFuture<>();
        strainSeen = now;
        pipeline.add(renderer -> {
            // the scale of strain stays in the picture once a spring was visible
            now.complete(renderer.draw(state) || before.join());
            int[] rgb = renderer.label(state, now.join());
            List<Runnable> rest = prepare(index, rgb);
            return () -> {
                rest.forEach(Runnable::run);
                for (int k = 1; k < times; k++) {
                    prepare(index + k, rgb).forEach(Runnable::run);
                }
            };
        }).whenComplete((done, failure) -> now.complete(false));     // so that nobody waits for a frame that failed
    }

    private List<Runnable> prepare(int index, int[] rgb) {
        return sinks.stream().map(sink -> sink.prepare(index, rgb)).toList();
    }

    /** Waits until all frames are drawn and written, and completes the files. */
    @Override
    public void close() {
        if (closed) {
            return;
        }
        closed = true;
        close(sinks);
    }

    private void close(List<FrameSink> open) {
        if (open.isEmpty()) {
            pipeline.close();
            return;
        }
        FrameSink sink = open.get(0);
        try (sink) {
            close(open.subList(1, open.size()));
        }
    }
}
