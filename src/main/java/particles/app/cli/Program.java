package particles.app.cli;

import java.io.PrintWriter;
import java.util.List;
import particles.spec.messages.InvalidInputException;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParseResult;

/**
 * Runs a command from its arguments and returns the exit code.
 *
 * @param commands the commands; each can be executed only once, since it holds its options
 * @param style    the way in which options are written in messages
 * @param out      the output for results
 * @param err      the error stream
 */
public record Program(List<ProgramCommand> commands, OptionStyle style, PrintWriter out, PrintWriter err) {
    /** The program's version, written to run.json; equal to that in build.gradle. */
    public static final String VERSION = "0.1.0";

    /**
     * @param args a command's name and its options, {@code --name=value}
     * @return the exit code
     */
    public ExitCode execute(String... args) {
        ExitCode code = ExitCode.DONE;
        try {
            run(args);
        } catch (Throwable thrown) {
            code = new Failures(err).print(thrown);
        }
        if (out.checkError()) {
            err.println("some output could not be printed: the destination is full or closed");
            code = code == ExitCode.DONE ? ExitCode.TROUBLE : code;
        }
        err.flush();
        return code;
    }

    private void run(String... args) throws Exception {
        CommandLine program = commandLine(args);
        ParseResult parsed = program.parseArgs(args);
        ParseResult chosen = parsed.hasSubcommand() ? parsed.subcommand() : parsed;
        if (chosen.isUsageHelpRequested()) {
            out.print(style.help(chosen.commandSpec().commandLine().getUsageMessage()));
            return;
        }
        List<Exception> errors = parsed.errors().isEmpty() ? chosen.errors() : parsed.errors();
        List<String> mistakes = new UsageFailures(style).of(errors);
        ProgramCommand command = chosen.commandSpec().userObject() instanceof ProgramCommand one ? one : null;
        if (command != null) {
            command.typedIn(style);
            mistakes.addAll(command.mistakes());
        } else if (mistakes.isEmpty()) {
            mistakes.add(new UsageFailures(style).noCommand(program));
        }
        if (!mistakes.isEmpty()) {
            throw new InvalidInputException(mistakes);
        }
        command.run(out);
    }

    private CommandLine commandLine(String... args) {
        CommandLine program = new CommandLine(new Root());
        // finding options by reflection is slow, so it is done for all commands only if none is named
        List<ProgramCommand> named = commands.stream().filter(command -> args.length > 0
                && command.name().equals(args[0])).toList();
        for (ProgramCommand command : named.isEmpty() ? commands : named) {
            program.addSubcommand(command.name(), new CommandLine(command));
        }
        // no @file arguments; all errors are reported together
        program.setExpandAtFiles(false);
        collectErrors(program.getCommandSpec());
        program.getSubcommands().values().forEach(line -> collectErrors(line.getCommandSpec()));
        return program;
    }

    private static void collectErrors(CommandSpec spec) {
        spec.parser().collectErrors(true);
    }

    /** The root command of the command line parser, without a command's name. */
    @Command(name = "desolver", description = "Physically-based animation for teaching.")
    private static final class Root {
        @CommandLine.Option(names = "--help", usageHelp = true, description = "Shows the commands.")
        private boolean help;
    }
}
