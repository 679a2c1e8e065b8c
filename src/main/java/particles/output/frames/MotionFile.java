package particles.output.frames;

import particles.output.painters.FrameState;

/** A receiver of the states of a run at the times of its frames. */
@FunctionalInterface
public interface MotionFile extends AutoCloseable {
    /**
     * @param frame its number
     * @param state the state at that time
     */
    void write(int frame, FrameState state);

    /** Completes the file after the last frame. */
    @Override
    default void close() {
    }
}
