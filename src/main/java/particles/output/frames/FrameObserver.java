package particles.output.frames;

import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import particles.Motion;
import particles.Observer;
import particles.ParticleSystem;
import particles.Rule;
import particles.output.files.OutputException;
import particles.output.painters.FrameState;
import particles.output.painters.FrameState.FrameStructure;
import particles.output.painters.FrameState.TrailSample;
import particles.view.ParticleStyle.ParticleMark;

/**
 * An observer that draws frames at regular simulated times, frame i at i / fps. Between two steps the motion is
 * interpolated. The states are copied and drawn by other threads; closing waits for them.
 */
public final class FrameObserver implements Observer, AutoCloseable {
    /** A clock that is early by this part of a frame's time is so by round-off. */
    private static final double ROUNDING = 1e-9;

    /**
     * The time for which a step is shown in slow motion (s), the time for the last one, and the largest number of
     * frames.
     */
    private static final double EACH = 0.4;
    private static final double LAST = 1.6;
    private static final int MOST_FRAMES = 100;

    private final double fps;
    private final List<FrameSink> sinks;
    private final Pipeline<FrameRenderer> pipeline;
    private final List<ParticleMark> marks;
    private final TrailRecorder trails;
    private double[] between = {};
    /** Shared by all frames until a rule changes it: effects may reorder springs, which decides what hides what. */
    private FrameStructure structure;
    private CompletableFuture<Boolean> strainSeen = CompletableFuture.completedFuture(false);
    private FrameState opening;
    private boolean closed;
    private int every = 1;
    private int index;

    /**
     * @param renderer draws the frames; from now on used by other threads alone
     * @param fps      frames a second of simulated time, positive
     * @param sinks    receive the frames; closed after the last one
     */
    public FrameObserver(FrameRenderer renderer, double fps, List<? extends FrameSink> sinks) {
        this(renderer, fps, sinks, Pipeline.threads(renderer.bytes()));
    }

    /** @param threads the number of threads that draw; the frames are the same with any number */
    FrameObserver(FrameRenderer renderer, double fps, List<? extends FrameSink> sinks, int threads) {
        this.fps = fps;
        marks = renderer.style().marks();
        trails = new TrailRecorder(renderer.style().longestTrail(), fps);
        this.sinks = List.copyOf(sinks);
        pipeline = new Pipeline<>(threads, () -> renderer.another(opening));
    }

    /** Leaves out all frames but every n-th one; trails stay as smooth as with all of them. */
    public void drawOnlyEvery(int n) {
        every = n;
    }

    @Override
    public void started(ParticleSystem system) {
        structure = null;
        index = (int) Math.max(0, Math.ceil(system.getTime() * fps - ROUNDING));
        trails.take(system.getTime(), system.getOwnState(), system.getParticles());
        drawIfDue(system);
    }

    @Override
    public double getNextTime() {
        return Math.min(index / fps, trails.getNextTime());
    }

    @Override
    public void moved(Motion motion) {
        ParticleSystem system = motion.getSystem();
        if (between.length != motion.getEndState().length) {
            between = new double[motion.getEndState().length];
        }
        for (double time = getNextTime(); time <= motion.getEndTime(); time = getNextTime()) {
            motion.interpolate(time, between);
            trails.take(time, between, system.getParticles());
            if (time == index / fps) {
                draw(system, between);
            }
        }
    }

    /** Notes an impact, or that springs may have torn and particles been born or removed: copies take them anew. */
    @Override
    public void changed(ParticleSystem system, Rule rule) {
        structure = null;
        trails.takeCorner(system.getTime(), system.getOwnState(), system.getParticles());
    }

    @Override
    public void finished(ParticleSystem system) {
        drawIfDue(system);
        close();
    }

    /** Draws frames that are due; at the end of a run the clock may be early by round-off. */
    private void drawIfDue(ParticleSystem system) {
        if (index <= system.getTime() * fps + ROUNDING) {
            draw(system, system.getOwnState());
        }
    }

    private void draw(ParticleSystem system, double[] state) {
        if (index % every == 0) {
            show(frame(system, index / fps, state, trails.samples(), List.of()), 1);
        } else {
            index++;
        }
    }

    private FrameState frame(ParticleSystem system, double time, double[] state, List<TrailSample> trail,
            List<String> notes) {
        return new FrameState(time, Arrays.copyOf(state, system.getStateSize()), structure(system), trail, notes);
    }

    private FrameStructure structure(ParticleSystem system) {
        if (structure == null) {
            structure = FrameStructure.of(system, marks);
        }
        return structure;
    }

    /**
     * Shows the last steps of a run that ended early once more, after its last frame: one at a time, and slowly.
     *
     * @param system   the system at the end of the run
     * @param last     its last steps
     * @param headline the text in each picture, such as the time of the blow-up
     */
    public void replay(ParticleSystem system, LastSteps last, String headline) {
        List<LastSteps.Step> steps = last.steps();
        List<String> notes = List.of(headline, "slow motion, step by step");
        for (int k = 0; k < steps.size(); k++) {
            LastSteps.Step step = steps.get(k);
            if (step.state().length == system.getStateSize()) {
                boolean end = k == steps.size() - 1;
                show(frame(system, step.time(), step.state(), List.of(), notes),
                        (int) Math.max(1, Math.min(MOST_FRAMES, Math.round((end ? LAST : EACH) * fps))));
            }
        }
    }

    /** @param times the number of frames that show the picture, from frame index on */
    private void show(FrameState state, int times) {
        if (opening == null) {
            opening = state;
        }
        int first = index;
        index += times;
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
        if (!closed) {
            closed = true;
            close(sinks);
        }
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
