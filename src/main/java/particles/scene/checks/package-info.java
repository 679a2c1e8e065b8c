/** Checks of a whole scene before it is built: ids that exist, particles outside solids, sizes that fit into memory. */
package particles.scene.checks;
