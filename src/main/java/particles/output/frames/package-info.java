/**
 * From a running simulation to drawn frames: a {@link particles.output.frames.FrameObserver} has frames drawn at
 * regular times by a {@link particles.output.frames.FrameRenderer}, on another thread, and hands them to {@link
 * particles.output.frames.FrameSink}s such as {@link particles.output.frames.PngFrames}. Only painters that the scene
 * needs are made.
 */
package particles.output.frames;
