/**
 * The frames of a running simulation: a {@link particles.output.frames.FrameObserver} takes them at regular times and
 * hands them to {@link particles.output.frames.MotionFile}s. One of these, the {@link
 * particles.output.frames.FrameDrawer}, has them drawn by a {@link particles.output.frames.FrameRenderer}, on other
 * threads, for {@link particles.output.frames.FrameSink}s. Only the painters that a scene needs are created.
 */
package particles.output.frames;
