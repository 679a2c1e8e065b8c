/**
 * The command line behind the gradle tasks: the only package that prints and that ends with an exit code.
 *
 * <p>Each command is one class, a {@link particles.app.cli.ProgramCommand} with its options declared as annotated
 * fields, and one entry of {@code Main.commands}; its gradle task is one line of {@code build.gradle}. A command that
 * fails throws an exception; {@link particles.app.cli.Failures} alone turns it into lines and an exit code.
 */
package particles.app;
