package particles.law;

/**
 * How far a state is off a constraint: a rod's length, a wire, a surface or a ball in contact; or how wrong the
 * reported work of moving anchors is.
 *
 * @param part the distance, as a fraction of the constraint's scale: the length of a rod, the distance of two
 *             balls in contact, the radius of a curved surface, or 1 m; or the error, as a fraction of the work
 * @param what what is wrong and by how much, in words
 */
public record Violation(double part, String what) {
    /** No violation. */
    public static final Violation NONE = new Violation(0, "");

    /** @return the larger of two violations */
    public Violation or(Violation other) {
        return other.part > part ? other : this;
    }
}
