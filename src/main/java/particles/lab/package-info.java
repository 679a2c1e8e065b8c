/**
 * The lab: runs a scene step by step while the user watches, and keeps its history. It needs no threads, files or
 * reflection, so that it runs in a browser page too.
 */
package particles.lab;
