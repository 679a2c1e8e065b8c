package particles.spec;

/** One of several things that a list's entry can be, each with keys of its own: an effect, a rule, a shape. */
public interface Kind {
    /** @return the name by which scenes choose it */
    String name();

    /** @return what it is, in one sentence */
    String sentence();

    /** @return what can be said of it */
    MappingType keys();
}
