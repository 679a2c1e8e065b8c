package particles.app.cli;

import java.io.PrintWriter;
import java.util.List;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParseResult;

/** The program as a function: commands, arguments and two streams in, an exit code out. */
public final class Program {
    private final List<ProgramCommand> commands;
    private final OptionStyle style;
    private final PrintWriter out;
    private final PrintWriter err;

    /**
     * @param commands what it can do; each is used for one call of {@link #execute} only, as it holds that call's
     *                 options
     * @param style    how options are written in what is printed
     * @param out      where results go
     * @param err      where it goes what is wrong
     */
    public Program(List<ProgramCommand> commands, OptionStyle style, PrintWriter out, PrintWriter err) {
        this.commands = commands;
        this.style = style;
        this.out = out;
        this.err = err;
    }

    /**
     * @param args a command's name and its options, {@code --name=value}
     * @return how the program ends
     */
    public ExitCode execute(String... args) {
        try {
            run(args);
            return ExitCode.DONE;
        } catch (Throwable thrown) {
            return new Failures(err).print(thrown);
        } finally {
            out.flush();
            err.flush();
        }
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
        if (!errors.isEmpty()) {
            throw new UsageFailures(style).of(errors);
        }
        if (!(chosen.commandSpec().userObject() instanceof ProgramCommand command)) {
            throw new UsageFailures(style).noCommand(program);
        }
        command.run(out);
    }

    private CommandLine commandLine(String... args) {
        CommandLine program = new CommandLine(new Root());
        // Options are found by reflection, which takes a while for all commands: only where none is named are all
        // needed.
        List<ProgramCommand> named = commands.stream().filter(command -> args.length > 0
                && name(command).equals(args[0])).toList();
        for (ProgramCommand command : named.isEmpty() ? commands : named) {
            program.addSubcommand(name(command), new CommandLine(command));
        }
        // No @file: a value is a value. All that is wrong is said in one go.
        program.setExpandAtFiles(false);
        collectErrors(program.getCommandSpec());
        program.getSubcommands().values().forEach(line -> collectErrors(line.getCommandSpec()));
        return program;
    }

    private static String name(ProgramCommand command) {
        return command.getClass().getAnnotation(Command.class).name();
    }

    private static void collectErrors(CommandSpec spec) {
        spec.parser().collectErrors(true);
    }

    /** The program without a command. */
    @Command(name = "desolver", description = "Physically-based animation for teaching.")
    private static final class Root {
        @CommandLine.Option(names = "--help", usageHelp = true, description = "Shows the commands.")
        private boolean help;
    }
}
