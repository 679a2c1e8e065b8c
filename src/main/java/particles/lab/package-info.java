/**
 * The lab: a scene that is run step by step while somebody watches, with all that was seen so far. Nothing here needs
 * threads, files or reflection, so that it runs in a browser page too.
 */
package particles.lab;
