package particles.app.cli;

import deSolvers.text.DidYouMean;
import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import particles.spec.messages.InvalidInputException;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.MissingParameterException;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.OverwrittenOptionException;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.TypeConversionException;
import picocli.CommandLine.UnmatchedArgumentException;

/**
 * Runs a command from its arguments and returns the exit code.
 *
 * @param commands the commands; each can be executed only once, since it holds its options
 * @param style    the way in which options are written in messages
 * @param out      the output for results, which each line reaches at once
 * @param err      the error stream, likewise
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
            Failures.lines(thrown).forEach(err::println);
            code = Failures.code(thrown);
        }
        if (out.checkError()) {
            err.println("some output could not be printed: the destination is full or closed");
            code = code == ExitCode.DONE ? ExitCode.TROUBLE : code;
        }
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
        List<String> mistakes = mistakes(errors);
        ProgramCommand command = chosen.commandSpec().userObject() instanceof ProgramCommand one ? one : null;
        if (command != null) {
            // after any other error than an unknown option the parser sets no default values
            if (errors.stream().allMatch(UnmatchedArgumentException.class::isInstance)) {
                mistakes.addAll(command.mistakes(style));
            }
        } else if (mistakes.isEmpty()) {
            mistakes.add("a command is missing; commands: " + commands(program));
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
        program.setCaseInsensitiveEnumValuesAllowed(true);
        collectErrors(program.getCommandSpec());
        program.getSubcommands().values().forEach(line -> collectErrors(line.getCommandSpec()));
        return program;
    }

    private static void collectErrors(CommandSpec spec) {
        spec.parser().collectErrors(true);
    }

    /**
     * Messages for invalid commands and options: the text found, the allowed ones, and the most similar of these.
     *
     * @param errors all errors of the command line parser
     * @return a line for each
     */
    private List<String> mistakes(List<Exception> errors) {
        List<String> lines = new ArrayList<>();
        for (Exception error : errors) {
            ParameterException e = (ParameterException) error;
            if (e instanceof UnmatchedArgumentException unmatched) {
                unmatched.getUnmatched().forEach(found -> lines.add(unmatched(e.getCommandLine(), found)));
            } else {
                lines.add(invalid(e));
            }
        }
        return lines;
    }

    private String unmatched(CommandLine line, String found) {
        boolean option = found.startsWith("-");
        if (line.getParent() == null) {
            return option ? "option " + found + " has to follow a command; commands: " + commands(line)
                    : "unknown command '" + found + "'" + DidYouMean.hint(found, line.getSubcommands().keySet(),
                    "'%s'"::formatted)
                    + " commands: " + commands(line);
        }
        if (!option) {
            return "unexpected '" + found + "'; options are written " + style.option("name") + "=value; allowed: "
                    + options(line);
        }
        String name = OptionStyle.bare(found);
        return "unknown option " + style.typed(found) + DidYouMean.hint(name, names(line), style::option)
                + " allowed: " + options(line);
    }

    private String invalid(ParameterException e) {
        if (e instanceof MissingParameterException missing
                && missing.getMissing().get(0) instanceof OptionSpec option) {
            return "option " + name(option) + " needs a value: " + name(option) + "=" + option.paramLabel();
        }
        if (e instanceof OverwrittenOptionException twice && twice.getOverwritten() instanceof OptionSpec option) {
            return "option " + name(option) + " was given twice";
        }
        if (e.getArgSpec() instanceof OptionSpec option && e.getCause() instanceof TypeConversionException wrong) {
            return "option " + name(option) + (option.type() == boolean.class
                    ? " has to be true or false, not '" + e.getValue() + "'" : ": " + wrong.getMessage());
        }
        return e.getMessage();
    }

    private String name(OptionSpec option) {
        return style.option(option.longestName());
    }

    private static String commands(CommandLine program) {
        return String.join(", ", program.getSubcommands().keySet());
    }

    private String options(CommandLine line) {
        return String.join(", ", names(line).stream().map(style::option).toList());
    }

    private static List<String> names(CommandLine line) {
        CommandSpec command = line.getCommandSpec();
        return command.options().stream().sorted(Comparator.comparing(OptionSpec::usageHelp))   // help comes last
                .map(option -> OptionStyle.bare(option.longestName())).toList();
    }

    /** The root command of the command line parser, without a command's name. */
    @Command(name = "desolver", description = "Physically-based animation for teaching.")
    private static final class Root {
        @CommandLine.Option(names = "--help", usageHelp = true, description = "Shows the commands.")
        @SuppressWarnings("UnusedVariable")
        private boolean help;
    }
}
