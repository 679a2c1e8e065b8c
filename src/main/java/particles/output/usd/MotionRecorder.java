package particles.output.usd;

import java.util.Arrays;
import java.util.List;
import particles.Motion;
import particles.Observer;
import particles.ParticleSystem;
import particles.Rule;
import particles.output.painters.FrameState;
import particles.output.painters.FrameState.FrameStructure;
import particles.view.ParticleStyle.ParticleMark;

/** An observer that writes motion files: frame i is at time i / rate, interpolated between steps. */
public final class MotionRecorder implements Observer, AutoCloseable {
    /** A clock that is early by this part of a frame's time is so by round-off. */
    private static final double ROUNDING = 1e-9;

    private final double rate;
    private final List<ParticleMark> marks;
    private final List<MotionFile> files;
    private FrameStructure structure;
    private int frame;

    /**
     * @param rate  frames per second of simulated time
     * @param marks particles that are drawn in their own way
     * @param files receive the frames
     */
    public MotionRecorder(double rate, List<ParticleMark> marks, List<MotionFile> files) {
        this.rate = rate;
        this.marks = marks;
        this.files = files;
    }

    @Override
    public void started(ParticleSystem system) {
        frame = (int) Math.ceil(system.getTime() * rate - ROUNDING);
        finished(system);
    }

    @Override
    public double getNextTime() {
        return frame / rate;
    }

    /** A frame at the end of a step waits for the rules, as in the trajectory: it is the beginning of the next one. */
    @Override
    public void moved(Motion motion) {
        double[] between = new double[motion.getEndState().length];
        while (frame < motion.getEndTime() * rate - ROUNDING) {
            motion.interpolate(Math.max(motion.getStartTime(), getNextTime()), between);
            write(motion.getSystem(), between);
        }
    }

    @Override
    public void changed(ParticleSystem system, Rule rule) {
        structure = null;
    }

    /** Writes a frame that is due: at the end of a run the clock may be early by round-off. */
    @Override
    public void finished(ParticleSystem system) {
        if (frame <= system.getTime() * rate + ROUNDING) {
            write(system, system.getOwnState());
        }
    }

    private void write(ParticleSystem system, double[] state) {
        structure = structure == null ? FrameStructure.of(system, marks) : structure;
        FrameState shown = new FrameState(getNextTime(), Arrays.copyOf(state, system.getStateSize()), structure,
                List.of(), List.of());
        files.forEach(file -> file.write(frame, shown));
        frame++;
    }

    /** Completes the files, also if the run ended early. */
    @Override
    public void close() {
        files.forEach(MotionFile::close);
    }
}
