package particles.effects.springs;

import deSolvers.ForceDerivatives;
import particles.law.Particles;

/**
 * The derivative of a damped spring's force. With u = r/|r|, w = r' and the tension tau = k (|r| - l) + k_d (u . w):
 * <pre>
 *   dF_ij/dr  = k u u^T + tau/|r| (1 - u u^T) + k_d/|r| u (w - (u . w) u)^T
 *   dF_ij/dr' = k_d u u^T
 * </pre>
 * and dF_ij/dx_i = -dF_ij/dr. The second term is negative for a compressed spring, which tends to buckle. The last one
 * is not symmetric; it appears when a damped spring rotates.
 *
 * <p>Source: derived from the slide "Damped Spring Force"; for l = 0 or k_d = 0 as in D. Baraff, A. Witkin (1998).
 */
final class SpringJacobian {
    /** The direction of shorter springs is only round-off. */
    private static final double SHORTEST = 1e-140;

    private final double[] dFdX = new double[9];
    private final double[] dFdV = new double[9];
    private final double[] u = new double[3];
    private final double[] turning = new double[3];

    /** Adds the blocks of spring {@code s}. */
    void add(double[] state, SpringTable table, int s, ForceDerivatives derivatives) {
        int i = table.from[s];                          // F_ij acts on this particle; its state index
        int j = table.to[s];
        double stiffness = table.stiffness[s];
        double damping = table.damping[s];
        double length = direction(state, i, j);
        // without direction: as for rest length 0
        double across = -stiffness;
        double along = 0;
        double drag = 0;
        if (length > 0) {
            double stretching = 0;
            for (int c = 0; c < 3; c++) {
                turning[c] = state[j + 3 + c] - state[i + 3 + c];
                stretching += u[c] * turning[c];
            }
            for (int c = 0; c < 3; c++) {
                turning[c] = damping * (turning[c] - stretching * u[c]) / length;
            }
            across = -(stiffness * (length - table.restLength[s]) + damping * stretching) / length;
            along = -stiffness - across;
            drag = -damping;
        }
        for (int row = 0, e = 0; row < 3; row++) {
            for (int column = 0; column < 3; column++, e++) {
                dFdX[e] = along * u[row] * u[column] - u[row] * turning[column] + (row == column ? across : 0);
                dFdV[e] = drag * u[row] * u[column];
            }
        }
        derivatives.addPair(i / Particles.STRIDE, j / Particles.STRIDE, dFdX, dFdV);
    }

    /** Writes u and returns |r|; both are 0 for a spring too short to have a direction. */
    private double direction(double[] state, int i, int j) {
        double largest = 0;
        for (int c = 0; c < 3; c++) {
            u[c] = state[j + c] - state[i + c];
            turning[c] = 0;
            largest = Math.max(largest, Math.abs(u[c]));
        }
        if (!(largest > SHORTEST)) {
            u[0] = 0;
            u[1] = 0;
            u[2] = 0;
            return 0;
        }
        double square = 0;
        for (int c = 0; c < 3; c++) {
            u[c] /= largest;
            square += u[c] * u[c];
        }
        double length = Math.sqrt(square);
        for (int c = 0; c < 3; c++) {
            u[c] /= length;
        }
        return largest * length;
    }
}
