package particles.law;

/**
 * An effect whose forces are split into blocks that several threads can evaluate in parallel, each with a range of
 * particles of its own, and a rest: the forces between two ranges, evaluated after the blocks. The parts do not depend
 * on the number of threads, so neither do the bits of the sums.
 */
public interface DivisibleEffect extends Effect {

    /** Prepares an evaluation of a state; called by one thread before {@link #countBlocks}. */
    default void prepare(double[] state) {
    }

    /**
     * Prepares an evaluation; called by one thread before {@link #addPart}.
     *
     * @return the number of blocks n, 1 or more
     */
    int countBlocks();

    /** @return the number of forces to compute; it decides whether several threads are worth their overhead */
    int size();

    /**
     * Adds the forces of one part.
     *
     * @param part  0 to n - 1 for the blocks, n for the rest
     * @param state the particles' state; read only
     * @param time  t (s)
     * @param force add each force (N) to the entries that hold the particle's velocity in the state
     */
    void addPart(int part, double[] state, double time, double[] force);
}
