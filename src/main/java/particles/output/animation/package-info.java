/**
 * Writers of frames as one animated GIF or one MP4 film, and the film of a race: several runs side by side.
 */
package particles.output.animation;
