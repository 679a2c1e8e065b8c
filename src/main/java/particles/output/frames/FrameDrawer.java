package particles.output.frames;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import particles.ParticleSystem;
import particles.output.files.OutputException;
import particles.output.painters.FrameState;
import particles.output.painters.FrameState.FrameStructure;

/** Has frames drawn by other threads; closing waits for them. */
public final class FrameDrawer implements MotionFile {
    /**
     * The time for which a step is shown in slow motion (s), the time for the last one, and the largest number of
     * frames.
     */
    private static final double EACH = 0.4;
    private static final double LAST = 1.6;
    private static final int MOST_FRAMES = 100;

    private final FrameRenderer renderer;
    private final List<FrameSink> sinks;
    private final Pipeline<FrameRenderer> pipeline;
    private CompletableFuture<Boolean> strainSeen = CompletableFuture.completedFuture(false);
    private FrameState opening;
    private int next;

    /**
     * @param renderer draws the frames; from now on used by other threads alone
     * @param sinks    receive the frames; closed after the last one
     */
    public FrameDrawer(FrameRenderer renderer, List<? extends FrameSink> sinks) {
        this(renderer, sinks, Pipeline.threads(renderer.bytes()));
    }

    /** @param threads the number of threads that draw; the frames are the same with any number */
    FrameDrawer(FrameRenderer renderer, List<? extends FrameSink> sinks, int threads) {
        this.renderer = renderer;
        this.sinks = List.copyOf(sinks);
        pipeline = new Pipeline<>(threads, () -> renderer.another(opening));
    }

    @Override
    public void write(int frame, FrameState state) {
        show(frame, state, 1);
    }

    /**
     * Shows the last steps of a run that ended early once more, after its last frame: one at a time, and slowly.
     *
     * @param system   the system at the end of the run
     * @param last     its last steps
     * @param headline the text in each picture, such as the time of the blow-up
     * @param fps      frames per second of simulated time
     */
    public void replay(ParticleSystem system, LastSteps last, String headline, double fps) {
        List<LastSteps.Step> steps = last.steps();
        List<String> notes = List.of(headline, "slow motion, step by step");
        FrameStructure structure = FrameStructure.of(system, renderer.style().marks());
        for (int k = 0; k < steps.size(); k++) {
            LastSteps.Step step = steps.get(k);
            if (step.state().length == system.getStateSize()) {
                boolean end = k == steps.size() - 1;
                show(next, new FrameState(step.time(), step.state(), structure, List.of(), notes),
                        (int) Math.max(1, Math.min(MOST_FRAMES, Math.round((end ? LAST : EACH) * fps))));
            }
        }
    }

    /** @param times the number of frames that show the picture, from frame {@code first} on */
    private void show(int first, FrameState state, int times) {
        if (opening == null) {
            opening = state;
        }
        next = first + times;
        CompletableFuture<Boolean> before = strainSeen;
        CompletableFuture<Boolean> now = new CompletableFuture<>();
        strainSeen = now;
        pipeline.add(renderer -> {
            // the scale of strain stays in the picture once a spring was visible
            now.complete(renderer.draw(state) || before.join());
            int[] rgb = renderer.label(state, now.join());
            List<Runnable> rest = prepare(first, rgb);
            return () -> {
                rest.forEach(Runnable::run);
                for (int k = 1; k < times; k++) {
                    prepare(first + k, rgb).forEach(Runnable::run);
                }
            };
        }).whenComplete((done, failure) -> now.complete(false));     // so that nobody waits for a frame that failed
    }

    private List<Runnable> prepare(int frame, int[] rgb) {
        return sinks.stream().map(sink -> sink.prepare(frame, rgb)).toList();
    }

    /**
     * Waits until the frames so far are written, and completes the files.
     *
     * @throws OutputException if something could not be written and no earlier call reported it
     */
    @Override
    public void close() {
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
