package particles.spec;

/** Finds kinds that a file names by their class, such as a student's own effect. */
public interface ClassNames {
    /**
     * @param example such a name
     * @return the type of texts that look like a class's full name
     */
    static TextType form(String example) {
        return TextType.of("the full name of a class, such as " + example,
                "^[A-Za-z_$][\\w$]*(\\.[A-Za-z_$][\\w$]*)+$");
    }

    /**
     * @param name the full name of a class
     * @param type the sort of kind that it has to declare
     * @param <K>  that sort
     * @return the kind that the class declares
     * @throws IllegalArgumentException if there is none; the message is one line with the remedy
     */
    <K extends Kind> K find(String name, Class<K> type);

    /** @return a finder without any classes */
    static ClassNames none() {
        return new ClassNames() {
            @Override
            public <K extends Kind> K find(String name, Class<K> type) {
                throw new IllegalArgumentException("class '" + name
                        + "' cannot be used here; take an effect from the list in the scene reference");
            }
        };
    }
}
