package particles.spec;

/** A named kind of list entry with its own keys: an effect, a rule, a shape. */
public interface Kind {
    /** @return the name by which scenes choose it */
    String name();

    /** @return what it is, in one sentence */
    String sentence();

    /** @return its keys */
    MappingType keys();
}
