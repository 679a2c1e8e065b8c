package deSolvers.implicit;

/**
 * The negative semidefinite part of a symmetric 3 x 3 matrix: its eigenvectors, with positive eigenvalues replaced by
 * 0. For a spring's dF/dx this is the restoring part; a compressed spring also has a negative stiffness, which pushes
 * an end that moves sideways further that way.
 */
final class NegativeSemidefinitePart {
    private static final int SWEEPS = 8;

    private final double[] a = new double[9];
    private final double[] v = new double[9];

    /** Computes that of the symmetric part of K, by Jacobi's rotations. */
    void compute(double[] k, double[] result) {
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++) {
                a[3 * i + j] = (k[3 * i + j] + k[3 * j + i]) / 2;
                v[3 * i + j] = i == j ? 1 : 0;
            }
        }
        for (int sweep = 0; sweep < SWEEPS; sweep++) {
            rotate(0, 1);
            rotate(0, 2);
            rotate(1, 2);
        }
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++) {
                double sum = 0;
                for (int e = 0; e < 3; e++) {
                    sum += Math.min(0, a[4 * e]) * v[3 * i + e] * v[3 * j + e];
                }
                result[3 * i + j] = sum;
            }
        }
    }

    /** Makes entry (p, q) zero. */
    private void rotate(int p, int q) {
        double off = a[3 * p + q];
        if (off == 0) {
            return;
        }
        double theta = (a[4 * q] - a[4 * p]) / (2 * off);
        double t = Math.abs(theta) > 1e150 ? 0.5 / theta
                : (theta < 0 ? -1 : 1) / (Math.abs(theta) + Math.sqrt(theta * theta + 1));
        double c = 1 / Math.sqrt(t * t + 1);
        double s = t * c;
        for (int i = 0; i < 3; i++) {
            turn(a, 3 * i + p, 3 * i + q, c, s);
        }
        for (int i = 0; i < 3; i++) {
            turn(a, 3 * p + i, 3 * q + i, c, s);
            turn(v, 3 * i + p, 3 * i + q, c, s);
        }
    }

    /** Turns two entries of a matrix into each other. */
    private static void turn(double[] m, int p, int q, double c, double s) {
        double atP = m[p];
        double atQ = m[q];
        m[p] = c * atP - s * atQ;
        m[q] = s * atP + c * atQ;
    }
}
