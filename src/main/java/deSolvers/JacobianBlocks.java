package deSolvers;

/**
 * Receives the 3 x 3 blocks of a second-order source's force derivatives, one by one, in any order; blocks for the same
 * pair are added up. A block is 9 doubles by rows: entry 3 a + b is the derivative of component a of the force by
 * component b of the position or velocity. The arrays are the caller's and may be used again at once.
 */
public interface JacobianBlocks {

    /**
     * Adds the derivative of the force on one particle with respect to the position and velocity of the same or another
     * particle.
     *
     * @param i    the particle on which the force acts: number of its block in the state
     * @param j    the particle whose position and velocity are varied
     * @param dFdX 9 doubles, the derivative of F<sub>i</sub> by x<sub>j</sub> (N/m)
     * @param dFdV 9 doubles, the derivative of F<sub>i</sub> by v<sub>j</sub> (N s/m)
     */
    void add(int i, int j, double[] dFdX, double[] dFdV);

    /**
     * Adds the four blocks of a force between two particles that depends only on x<sub>j</sub> - x<sub>i</sub> and
     * v<sub>j</sub> - v<sub>i</sub> and acts on both with opposite signs: the given blocks at (i, i) and (j, j), their
     * negatives at (i, j) and (j, i).
     *
     * @param i    one particle
     * @param j    the other one
     * @param dFdX 9 doubles, the derivative of F<sub>i</sub> by x<sub>i</sub> (N/m)
     * @param dFdV 9 doubles, the derivative of F<sub>i</sub> by v<sub>i</sub> (N s/m)
     */
    void addPair(int i, int j, double[] dFdX, double[] dFdV);

    /**
     * Multiplies all blocks added so far for the force on one particle by a matrix. Reactions that depend on the total
     * force use it.
     *
     * @param i      the particle
     * @param matrix 9 doubles by rows, the derivative of the total force on the particle by the force before the
     *               reaction
     */
    void transformRow(int i, double[] matrix);
}
