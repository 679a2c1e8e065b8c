/**
 * {@code gradle run}: one scene, from its file to a folder of results, and the console output.
 */
package particles.app.run;
