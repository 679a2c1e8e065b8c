package particles;

/** Something that a run is made of, and that may know more of the run so far than the state and the clock say. */
public interface Remembering {

    /**
     * Passes all that is remembered from step to step through a memory, in an order of its own that is always the same. What
     * is only kept within a step, or follows from the scene alone, need not be.
     *
     * @param memory where it goes to, or comes from: then this object is as it was at its beginning, after the run's start
     */
    default void remember(Memory memory) {
    }
}
