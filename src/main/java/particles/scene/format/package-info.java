/**
 * The scene file's format: its keys, and the records that they are read into.
 */
package particles.scene.format;
