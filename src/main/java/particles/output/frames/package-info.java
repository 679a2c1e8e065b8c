/**
 * Drawing the frames of a running simulation: a {@link particles.output.frames.FrameObserver} has frames drawn at
 * regular times by a {@link particles.output.frames.FrameRenderer}, on another thread, and hands them to {@link
 * particles.output.frames.FrameSink}s. Only the painters that a scene needs are created.
 */
package particles.output.frames;
