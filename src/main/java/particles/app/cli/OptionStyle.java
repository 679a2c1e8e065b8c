package particles.app.cli;

/**
 * The way in which the user types an option: {@code -Pscene=2} with gradle, {@code --scene=2} with the start script.
 */
public enum OptionStyle {
    /** With two dashes, as the start script expects it. */
    SHELL("--"),
    /** With -P, as gradle expects it. */
    GRADLE("-P");

    /** The system property that build.gradle sets. */
    public static final String STARTED_BY = "desolver.startedBy";

    private final String prefix;

    OptionStyle(String prefix) {
        this.prefix = prefix;
    }

    /** @return the style for the way in which this program was started */
    public static OptionStyle current() {
        return "gradle".equals(System.getProperty(STARTED_BY)) ? GRADLE : SHELL;
    }

    /**
     * @param name an option's name, with or without dashes or -P before it
     * @return the option as the user types it
     */
    public String option(String name) {
        return prefix + bare(name);
    }

    /**
     * @param name a task's name
     * @return the task as the user types it
     */
    public String task(String name) {
        return (this == GRADLE ? "gradle " : "desolver ") + name;
    }

    /**
     * @param found an option as the program received it, with or without =value
     * @return the option as the user typed it, without the value
     */
    String typed(String found) {
        return this == GRADLE ? option(found) : found.replaceFirst("=.*", "");
    }

    /** @return the help text, with options as the user types them */
    String help(String text) {
        return text.replaceAll("(?<![\\w-])--(?=\\w)", prefix);
    }

    /** @return the name without dashes or -P before it, and without =value after it */
    static String bare(String option) {
        String name = option.replaceFirst("^(--?P(?=\\w)|-+)", "");
        return name.contains("=") ? name.substring(0, name.indexOf('=')) : name;
    }
}
