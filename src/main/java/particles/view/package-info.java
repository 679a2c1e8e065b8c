/**
 * Plain records of everything that can be drawn: the camera, the render options, surfaces, springs, charts and tables.
 * Experiments and the scene reader fill them; {@code particles.output} draws them.
 */
package particles.view;
