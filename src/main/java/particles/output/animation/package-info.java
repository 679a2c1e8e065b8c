/**
 * Writers of frames as one animated GIF or one MP4 film.
 */
package particles.output.animation;
