package particles.spec;

/** A named kind of list entry with its own keys: an effect, a rule, a shape, a wire. */
public abstract class Kind {
    private final String name;
    private final String sentence;
    private final MappingType keys;

    /**
     * @param name     the name by which scenes choose it
     * @param sentence a description in one sentence
     * @param keys     the keys that a scene can set
     */
    protected Kind(String name, String sentence, Key<?>... keys) {
        this(name, sentence, MappingType.of("'" + name + "'", keys));
    }

    /** As above, for keys that also have to fit together. */
    protected Kind(String name, String sentence, MappingType keys) {
        this.name = name;
        this.sentence = sentence;
        this.keys = keys;
    }

    /** @return the name by which scenes choose it */
    public final String getName() {
        return name;
    }

    /** @return a description in one sentence */
    public final String getSentence() {
        return sentence;
    }

    /** @return the keys that a scene can set */
    public final MappingType getKeys() {
        return keys;
    }
}
