package particles.output.frames;

import java.util.Arrays;
import java.util.List;
import particles.Motion;
import particles.Observer;
import particles.ParticleSystem;
import particles.Rule;
import particles.output.painters.FrameState;
import particles.output.painters.FrameState.FrameStructure;
import particles.view.ParticleStyle;

/**
 * An observer that takes frames at regular simulated times, frame i at i / fps. Between two steps the motion is
 * interpolated. A frame at the end of a step waits for the rules, as in the trajectory: it is the beginning of the next
 * one.
 */
public final class FrameObserver implements Observer, AutoCloseable {
    /** A clock that is early by this part of a frame's time is so by round-off. */
    private static final double ROUNDING = 1e-9;

    private final ParticleStyle style;
    private final double fps;
    private final List<MotionFile> files;
    private final TrailRecorder trails;
    private double[] between = {};
    /** Shared by all frames until a rule changes it: effects may reorder springs, which decides what hides what. */
    private FrameStructure structure;
    private boolean closed;
    private int index;

    /**
     * @param style the style of particles
     * @param fps   frames per second of simulated time, positive
     * @param files receive the frames; closed after the last one
     */
    public FrameObserver(ParticleStyle style, double fps, List<? extends MotionFile> files) {
        this.style = style;
        this.fps = fps;
        this.files = List.copyOf(files);
        trails = new TrailRecorder(style.longestTrail(), fps);
    }

    /** Has the frames drawn; the renderer is from now on used by other threads alone. */
    public FrameObserver(FrameRenderer renderer, double fps, List<? extends FrameSink> sinks) {
        this(renderer.style(), fps, List.of(new FrameDrawer(renderer, sinks)));
    }

    @Override
    public void started(ParticleSystem system) {
        structure = null;
        index = (int) Math.max(0, Math.ceil(system.getTime() * fps - ROUNDING));
        take(system, system.getTime(), system.getOwnState());
    }

    @Override
    public double getNextTime() {
        return Math.min(index / fps, trails.getNextTime());
    }

    @Override
    public void moved(Motion motion) {
        if (between.length != motion.getEndState().length) {
            between = new double[motion.getEndState().length];
        }
        while (getNextTime() * fps < motion.getEndTime() * fps - ROUNDING) {
            double time = Math.max(motion.getStartTime(), getNextTime());
            motion.interpolate(time, between);
            take(motion.getSystem(), time, between);
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
        take(system, system.getTime(), system.getOwnState());
        close();
    }

    /** Takes what is due; at the end of a run the clock may be early by round-off. */
    private void take(ParticleSystem system, double time, double[] state) {
        trails.take(time, state, system.getParticles());
        if (index <= time * fps + ROUNDING) {
            structure = structure == null ? FrameStructure.of(system, style.marks()) : structure;
            FrameState shown = new FrameState(index / fps, Arrays.copyOf(state, system.getStateSize()), structure,
                    trails.samples(), List.of());
            files.forEach(file -> file.write(index, shown));
            index++;
        }
    }

    /** Completes the files, also if the run ended early; all of them, also if one cannot be completed. */
    @Override
    public void close() {
        if (!closed) {
            closed = true;
            close(files);
        }
    }

    private static void close(List<MotionFile> open) {
        if (!open.isEmpty()) {
            MotionFile file = open.get(0);
            try (file) {
                close(open.subList(1, open.size()));
            }
        }
    }
}
