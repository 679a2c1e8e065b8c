/**
 * The commands that measure something and write a page of results.
 */
package particles.app.experiments;
