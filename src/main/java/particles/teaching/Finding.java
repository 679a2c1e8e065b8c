package particles.teaching;

/**
 * One finding of a check: a mistake or advice.
 *
 * @param kind  the kind of finding
 * @param cause what was found, a constant of one of the lists of findings; for one of a kind, its text
 * @param text  the finding as a sentence
 */
public record Finding(Kind kind, Object cause, String text) {

    /** A finding without a constant, such as the text of an exception. */
    public Finding(Kind kind, String text) {
        this(kind, text, text);
    }

    /** The kinds of findings. */
    public enum Kind {
        /** The formula is not that of the method. */
        METHOD("method"),
        /** The clock is not where it should be. */
        TIME("time"),
        /** The state is not read, set or left as it should be. */
        STATE("state"),
        /** The class cannot be used at all, or did not return. */
        FAILURE("failure"),
        /** It is a right method, and not the one that it is declared to be. */
        NAME("name"),
        /** Nothing is written yet, as in a skeleton. */
        UNWRITTEN("not yet"),
        /** The check did not come to an end: no mark, and no mistake. */
        UNDECIDED("not decided"),
        /** No mistake, but something that could be better. */
        STYLE("style");

        private final String word;

        Kind(String word) {
            this.word = word;
        }

        /** @return the kind in one word */
        public String word() {
            return word;
        }
    }

    /** @return whether this is a mistake, and not only style */
    public boolean isWrong() {
        return kind != Kind.STYLE;
    }

    @Override
    public String toString() {
        return kind.word() + ": " + text;
    }
}
