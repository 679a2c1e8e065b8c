package particles;

/**
 * An effect whose items fall into blocks that several threads can evaluate at once, since no two blocks touch the same
 * particle. Items that are in no block come last, and are evaluated by one thread when all blocks are done. The blocks
 * depend on the items alone and never on the number of threads, so that sums have the same bits for any number.
 */
public interface DivisibleEffect extends Effect {

    /**
     * Makes the effect ready to be evaluated; called by one thread before each evaluation.
     *
     * @return the number of blocks, 1 or more
     */
    int countBlocks();

    /**
     * @param block a block, or the number of blocks for what is in none
     * @return its first item; it ends where the next one begins, and what is in no block ends at {@link #size()}
     */
    int getBlockStart(int block);
}
