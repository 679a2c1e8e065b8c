/**
 * What has to hold between the parts of a scene before anything is built: ids that exist, particles outside of solids,
 * sizes that fit into memory.
 */
package particles.scene.checks;
