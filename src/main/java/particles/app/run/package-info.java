/**
 * {@code gradle run}: one scene, from its file to a folder of results, and what the console says meanwhile.
 */
package particles.app.run;
