package deSolvers;

/**
 * Collects the derivatives of forces with respect to positions and velocities, for implicit solvers. A {@link
 * SecondOrderStateSource}, or each of its effects and reactions, adds 3 x 3 blocks in any order; blocks for the same
 * pair are summed. A block is 9 doubles, row by row: entry 3 a + b is the derivative of component a of the force with
 * respect to component b of the position or velocity. The values are copied, so the caller may reuse its arrays.
 */
public interface ForceDerivatives {

    /**
     * Adds the derivative of the force on particle i with respect to the position and velocity of particle j (which may
     * be i itself).
     *
     * @param i    the particle on which the force acts
     * @param j    the particle whose position and velocity are varied
     * @param dFdX 9 doubles, dF<sub>i</sub>/dx<sub>j</sub> (N/m)
     * @param dFdV 9 doubles, dF<sub>i</sub>/dv<sub>j</sub> (N s/m)
     */
    void add(int i, int j, double[] dFdX, double[] dFdV);

    /**
     * Adds all four blocks of a pair force: one that depends only on x<sub>j</sub> - x<sub>i</sub> and v<sub>j</sub> -
     * v<sub>i</sub> and acts on the two particles with opposite signs.
     *
     * @param i    one particle
     * @param j    the other one
     * @param dFdX 9 doubles, dF<sub>i</sub>/dx<sub>i</sub> (N/m)
     * @param dFdV 9 doubles, dF<sub>i</sub>/dv<sub>i</sub> (N s/m)
     */
    void addPair(int i, int j, double[] dFdX, double[] dFdV);

    /**
     * Multiplies everything added so far for the force on one particle by a matrix. Reactions use it, since their force
     * depends on the force before them.
     *
     * @param i      the particle
     * @param matrix 9 doubles, row by row: the derivative of the total force on the particle with respect to the force
     *               before the reaction
     */
    void transformRow(int i, double[] matrix);
}
