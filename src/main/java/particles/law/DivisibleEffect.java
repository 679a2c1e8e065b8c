package particles.law;

/**
 * An effect whose forces are split into parts that several threads can evaluate in parallel. The parts form a binary
 * tree. Its n leaves are blocks, each with a range of particles of its own; an inner node, called a joint, holds the
 * forces between its two children and is evaluated after them. The tree does not depend on the number of threads, so
 * neither do the bits of the sums.
 */
public interface DivisibleEffect extends Effect {

    /** Prepares an evaluation of a state; called by one thread before {@link #countBlocks}. */
    default void prepare(double[] state) {
    }

    /**
     * Prepares an evaluation; called by one thread before {@link #addPart}.
     *
     * @return the number of blocks n, a power of two
     */
    int countBlocks();

    /** @return the number of forces to compute; it decides whether several threads are worth their overhead */
    int size();

    /**
     * Adds the forces of one block or joint.
     *
     * @param part  0 to n - 1 for the blocks; n to n + n/2 - 1 for the joints of two blocks, in order; the next n/4
     *              join these, and so on up to 2 n - 2, which joins all
     * @param state the particles' state; read only
     * @param time  t (s)
     * @param force add each force (N) to the entries that hold the particle's velocity in the state
     */
    void addPart(int part, double[] state, double time, double[] force);
}
