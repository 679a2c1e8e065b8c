package particles;

/**
 * An effect whose items fall into blocks that several threads can evaluate at once, since each has a range of particles to
 * itself. The blocks are the leaves of a binary tree: items that touch two blocks are in a joint, the smallest part of the tree
 * that both are in, and are evaluated when all of that part below is done; so joints side by side can be evaluated at once,
 * too. The division depends on the items alone and never on the number of threads, so that sums have the same bits for any
 * number.
 */
public interface DivisibleEffect extends Effect {

    /**
     * Makes the effect ready to be evaluated; called by one thread before each evaluation.
     *
     * @return the number of blocks n, a power of two
     */
    int countBlocks();

    /**
     * @param block a block, or a joint: n to n + n/2 - 1 join blocks in pairs, the next n/4 join these, and so on up to 2 n - 2,
     *              which joins all; or 2 n - 1
     * @return its first item; it ends where the next one begins, and the last at 2 n - 1, which is {@link #size()}
     */
    int getBlockStart(int block);

    /**
     * @param block a block, or n
     * @return the first particle of its range, which ends where the next one begins: 0 for the first block, and the number of
     *         all particles for n
     */
    int getFirstParticle(int block);
}
