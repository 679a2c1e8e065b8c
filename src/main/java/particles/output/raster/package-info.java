/**
 * The picture in memory: camera, light, colours, samples with depth, and the backdrop of sky, ground and spheres.
 */
package particles.output.raster;
