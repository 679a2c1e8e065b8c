package particles.law;

/**
 * Where effects and reactions put the derivatives of their forces by positions and velocities, for implicit solvers: 3
 * x 3 blocks, one by one, in any order; what arrives for the same pair is added up. A block is 9 doubles by rows: entry
 * 3 a + b is the derivative of component a of the force by component b of the position or velocity. The arrays are the
 * caller's and may be used again at once.
 */
public interface ForceDerivatives {

    /**
     * Adds the derivative of the force on one particle by the place and the velocity of one (the same or another).
     *
     * @param i    the particle on which the force acts
     * @param j    the particle whose position and velocity are varied
     * @param dFdX 9 doubles, the derivative of F<sub>i</sub> by x<sub>j</sub> (N/m)
     * @param dFdV 9 doubles, the derivative of F<sub>i</sub> by v<sub>j</sub> (N s/m)
     */
    void add(int i, int j, double[] dFdX, double[] dFdV);

    /**
     * Adds what a force between two particles contributes that depends on x<sub>j</sub> - x<sub>i</sub> and
     * v<sub>j</sub> - v<sub>i</sub> only, and acts on both with opposite signs.
     *
     * @param i    one particle
     * @param j    the other one
     * @param dFdX 9 doubles, the derivative of F<sub>i</sub> by x<sub>i</sub> (N/m)
     * @param dFdV 9 doubles, the derivative of F<sub>i</sub> by v<sub>i</sub> (N s/m)
     */
    void addPair(int i, int j, double[] dFdX, double[] dFdV);

    /**
     * Multiplies all that was added so far for the force on one particle: for a reaction whose answer depends on the
     * force.
     *
     * @param i      the particle
     * @param matrix 9 doubles by rows, the derivative of the total force on the particle by the force before the
     *               reaction
     */
    void transformRow(int i, double[] matrix);
}
