package particles.app.cli;

import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.NoSuchElementException;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import particles.spec.Key;
import particles.spec.Setting;
import particles.spec.messages.InvalidInputException;
import particles.spec.messages.Problems;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** Base class of a command: a class with {@code @Command} and {@code @Option} fields. */
public abstract class ProgramCommand {
    @Option(names = "--help", usageHelp = true, description = "Shows these options.")
    @SuppressWarnings("UnusedVariable")                 // the parser knows that it was given
    private boolean help;

    private OptionStyle style = OptionStyle.current();

    /** @return the way in which options are typed, for messages */
    public final OptionStyle getStyle() {
        return style;
    }

    /** @return the failure for a wrong option */
    public final InvalidInputException wrong(String option, String why) {
        return new InvalidInputException("option " + style.option(option) + ": " + why);
    }

    /**
     * Makes what an option names.
     *
     * @param option the option
     * @param making throws an exception whose message says why there is none
     * @return what it makes
     */
    protected final <T> T made(String option, Supplier<T> making) {
        try {
            return making.get();
        } catch (NoSuchElementException | IllegalArgumentException e) {
            throw wrong(option, e.getMessage());
        }
    }

    /**
     * @param option the option that gives values for keys of a scene
     * @param text   what was typed, {@code KEY = VALUE, KEY = VALUE ...}; may be blank
     * @return the settings
     */
    public final List<Setting> settings(String option, String text) {
        Problems problems = new Problems();
        List<Setting> settings = text.isBlank() ? List.of() : Setting.list(text, style.option(option), problems);
        problems.throwIfAny();
        return settings;
    }

    /**
     * Reads options that stand for keys of a scene.
     *
     * @param mistakes receives a line for each wrong one
     * @param keys     the keys, whose names the options have
     * @param typed    a value for each; null, as the parser has it, if the option was not given
     * @return the settings
     */
    public final Supplier<List<Setting>> settings(Mistakes mistakes, List<Key<?>> keys, String... typed) {
        return mistakes.value(() -> {
            Problems problems = new Problems();
            List<Setting> settings = IntStream.range(0, typed.length).filter(k -> typed[k] != null).mapToObj(k ->
                    Setting.of(keys.get(k), typed[k], style.option(keys.get(k).name()), problems))
                    .flatMap(Optional::stream).toList();
            problems.throwIfAny();
            return settings;
        });
    }

    /** Refuses a whole number that is out of its range; {@link Integer#MAX_VALUE} is no upper limit. */
    protected final void requireWithin(String option, int value, int least, int most) {
        if (value < least || value > most) {
            throw wrong(option, value + " has to be " + (most == Integer.MAX_VALUE ? least + " or more"
                    : "from " + least + " to " + most));
        }
    }

    /** @return the command's name, which is its task's */
    public String name() {
        return getClass().getAnnotation(Command.class).name();
    }

    /**
     * Reads the values of the options, once, and keeps them for the run.
     *
     * @param mistakes receives what is wrong with them
     */
    protected void read(Mistakes mistakes) {
    }

    /**
     * @param style the way in which options are typed, for messages
     * @return a line for each wrong option
     */
    public final List<String> mistakes(OptionStyle style) {
        this.style = style;
        Mistakes mistakes = new Mistakes();
        read(mistakes);
        return mistakes.lines();
    }

    /**
     * Runs the command; its options have been read, and none is wrong.
     *
     * @param out the output for results
     * @throws Exception any failure; {@link Failures} prints it
     */
    public abstract void run(PrintWriter out) throws Exception;

    /** @return the line that is printed when the command is cut off by Ctrl-C or another signal */
    public String whenStopped() {
        return name() + " was stopped";
    }

    /** Collects what is wrong with the options of a command, so that all of it is reported together. */
    public static final class Mistakes {
        private final Set<String> lines = new LinkedHashSet<>();    // values that need the same scene report it once

        /**
         * Reads a value.
         *
         * @param reading throws an {@link InvalidInputException} if an option is wrong
         * @return the value that was read; of a wrong one it throws the same exception again
         */
        public <T> Supplier<T> value(Supplier<T> reading) {
            try {
                T value = reading.get();
                return () -> value;
            } catch (InvalidInputException e) {
                lines.addAll(e.getLines());
                return () -> {
                    throw e;
                };
            }
        }

        /**
         * Checks a value.
         *
         * @param check throws an {@link InvalidInputException} if an option is wrong
         */
        public void check(Runnable check) {
            value(() -> {
                check.run();
                return true;
            });
        }

        List<String> lines() {
            return new ArrayList<>(lines);
        }
    }
}
