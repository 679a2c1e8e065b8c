/** Software rendering: camera, light, colours, depth buffer, and the background of sky, ground and spheres. */
package particles.output.raster;
