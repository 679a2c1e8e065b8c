package particles.app.cli;

import deSolvers.text.DidYouMean;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import picocli.CommandLine;
import picocli.CommandLine.MissingParameterException;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.OverwrittenOptionException;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.TypeConversionException;
import picocli.CommandLine.UnmatchedArgumentException;

/** Messages for invalid commands and options: the text found, the allowed ones, and the most similar of these. */
record UsageFailures(OptionStyle style) {
    /**
     * @param errors all errors of the command line parser
     * @return a line for each
     */
    List<String> of(List<Exception> errors) {
        List<String> lines = new ArrayList<>();
        for (Exception error : errors) {
            if (!(error instanceof ParameterException e)) {
                throw new IllegalStateException("the command line parser failed", error);
            }
            if (e instanceof UnmatchedArgumentException unmatched) {
                unmatched.getUnmatched().forEach(found -> lines.add(unmatched(e.getCommandLine(), found)));
            } else {
                lines.add(invalid(e));
            }
        }
        return lines;
    }

    /** @return the line for a program that was started without a command */
    String noCommand(CommandLine program) {
        return "a command is missing; commands: " + commands(program);
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
        return "unknown option " + style.typed(found) + DidYouMean.hint(name, names(line), style::option) + " allowed: "
                + options(line);
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
            return "option " + name(option) + (isYesOrNo(option)
                    ? " has to be true or false, not '" + e.getValue() + "'" : ": " + wrong.getMessage());
        }
        return e.getMessage();
    }

    private static boolean isYesOrNo(OptionSpec option) {
        return option.type() == boolean.class || option.type() == Boolean.class;
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
        return command.options().stream().sorted(Comparator.comparing(OptionSpec::usageHelp))       // help comes last
                .map(option -> OptionStyle.bare(option.longestName())).toList();
    }
}
