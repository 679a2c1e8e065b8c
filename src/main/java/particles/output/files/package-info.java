/**
 * Files that are written whole or not at all, the folder they are in, and the plain formats: trajectories as CSV, the
 * run's summary as JSON, pictures as PNG. {@code FontCheck} says whether text can be drawn.
 *
 * <p>An {@link particles.output.files.OutputFolder} is opened first. It lists its files in a hidden file, so that a new
 * run removes those of the last one. Failures throw an {@link particles.output.files.OutputException}, whose message is
 * one line for people. A stopping program calls {@link particles.output.files.OutputFolder#close} from its shutdown
 * hook: unfinished files are deleted, complete ones stay.
 */
package particles.output.files;
