/** The base of all commands: options, exit codes, and failures as lines without stack traces. */
package particles.app.cli;
