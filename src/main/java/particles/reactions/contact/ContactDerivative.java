package particles.reactions.contact;

import deSolvers.ForceDerivatives;
import java.util.Arrays;
import particles.law.Vector3;

/**
 * The derivative of the contact force on one particle. The pushing surfaces, with normals N_p, balance the force F
 * before: G lambda = -N . F with G_pq = N_p . N_q, so d lambda/dF = -G<sup>-1</sup> N<sup>T</sup>. Sliding friction
 * depends on lambda and on the velocity; static friction cancels the remaining force.
 *
 * <p>On a curved surface the normal changes with position, dN = kappa P dx with P = 1 - N N<sup>T</sup>, and the
 * centripetal term b = -m kappa v_t&sup2; with position and velocity; see {@link CurvedContact}.
 *
 * <p>Where a particle starts to slide or a surface to push, the force has a kink, and this is a one-sided derivative.
 */
final class ContactDerivative {
    private static final double[] NONE = new double[3];

    private final double[][] inverse = new double[3][3];    // of G, for the surfaces that push
    private final double[][] g = new double[3][3];
    private final double[] normal = new double[3];
    private final int[] pushing = new int[3];
    private final double[][] pushByForce;                   // d lambda_p / dF
    private final double[] total = new double[9];           // d (F + answer) / dF
    private final double[] dFdX = new double[9];
    private final double[] dFdV = new double[9];
    private final CurvedContact curved;
    private Vector3[] normals = {};
    private double[] push = {};

    ContactDerivative(int surfaces) {
        pushByForce = new double[surfaces][3];
        curved = new CurvedContact(surfaces);
    }

    /** Starts with a particle and its normal forces, without friction; its velocity begins at index v of the state. */
    void begin(int count, TouchedSurfaces touched, double mass, double[] state, int v) {
        normals = touched.normals;
        push = touched.push;
        Arrays.fill(dFdX, 0);
        Arrays.fill(dFdV, 0);
        Arrays.fill(total, 0);
        total[0] = 1;
        total[4] = 1;
        total[8] = 1;
        int active = 0;
        for (int p = 0; p < count; p++) {
            Arrays.fill(pushByForce[p], 0);
            if (push[p] != 0 && active < 3) {
                pushing[active++] = p;
            }
        }
        invertGram(active);
        for (int a = 0; a < active; a++) {
            double[] row = pushByForce[pushing[a]];
            for (int b = 0; b < active; b++) {
                addTo(row, -inverse[a][b], normals[pushing[b]]);
            }
            addProduct(total, 1, normals[pushing[a]], row);
        }
        curved.begin(touched, mass, state, v, pushing, active, inverse);
        for (int a = 0; a < active && curved.isAny(); a++) {
            int p = pushing[a];
            addProduct(dFdX, 1, normals[p], curved.pushByPlace[p]);
            addProduct(dFdV, 1, normals[p], curved.pushByVelocity[p]);
            curved.addTurning(p, push[p], dFdX);
        }
    }

    /** Gauss-Jordan elimination of the positive definite matrix of the normals' scalar products. */
    private void invertGram(int n) {
        for (int a = 0; a < n; a++) {
            for (int b = 0; b < n; b++) {
                g[a][b] = normals[pushing[a]].dot(normals[pushing[b]]);
                inverse[a][b] = a == b ? 1 : 0;
            }
        }
        for (int k = 0; k < n; k++) {
            double pivot = g[k][k];
            for (int c = 0; c < n; c++) {
                g[k][c] /= pivot;
                inverse[k][c] /= pivot;
            }
            for (int a = 0; a < n; a++) {
                double factor = g[a][k];
                for (int c = 0; c < n && a != k; c++) {
                    g[a][c] -= factor * g[k][c];
                    inverse[a][c] -= factor * inverse[k][c];
                }
            }
        }
    }

    /** Static friction: the total force is 0. */
    void hold() {
        Arrays.fill(total, 0);
        Arrays.fill(dFdX, 0);
        Arrays.fill(dFdV, 0);
    }

    /**
     * Sliding friction of surface p, minus factor times the direction.
     *
     * @param factor the result of {@link SlidingDirection#find}: proportional to the normal force, and for Coulomb's
     *               law inversely to the speed
     */
    void rub(int p, double factor, SlidingDirection sliding, Friction.Law law) {
        if (factor == 0) {
            return;
        }
        double[] t = sliding.direction;
        normal[0] = normals[p].x();
        normal[1] = normals[p].y();
        normal[2] = normals[p].z();
        double square = t[0] * t[0] + t[1] * t[1] + t[2] * t[2];
        if (sliding.isTowardsStop()) {                  // the direction depends on the force, not on the velocity
            for (int row = 0, e = 0; row < 3; row++) {
                for (int column = 0; column < 3; column++, e++) {
                    total[e] -= factor * ((row == column ? 1 : 0) - normal[row] * normal[column]
                            - (sliding.stops() ? 0 : t[row] * t[column] / square));
                }
            }
            if (sliding.stops()) {
                return;                                 // the normal force has no influence
            }
        }
        for (int row = 0; row < 3; row++) {
            for (int column = 0; column < 3; column++) {
                total[3 * row + column] -= factor / push[p] * t[row] * pushByForce[p][column];
                if (curved.isAny()) {
                    dFdX[3 * row + column] -= factor / push[p] * t[row] * curved.pushByPlace[p][column];
                    dFdV[3 * row + column] -= factor / push[p] * t[row] * curved.pushByVelocity[p][column];
                }
            }
        }
        if (sliding.isIndependentOfVelocity()) {
            return;
        }
        double[] m = sliding.mirrored;
        double mt = (m[0] * t[0] + m[1] * t[1] + m[2] * t[2]) / square;
        for (int row = 0, e = 0; row < 3; row++) {
            for (int column = 0; column < 3; column++, e++) {
                double along = (row == column ? 1 : 0) - normal[row] * normal[column];
                if (law == Friction.Law.COULOMB) {
                    along -= t[row] * t[column] / square + 2 * (m[row] - mt * t[row]) * m[column];
                }
                dFdV[e] -= factor * along;
            }
        }
        if (curved.isAny()) {
            curved.addTurningOfSlip(p, factor, law == Friction.Law.COULOMB ? t : NONE, m, dFdX);
        }
    }

    /** Transforms the particle's row and adds the derivatives with respect to its velocity. */
    void add(int i, ForceDerivatives derivatives) {
        derivatives.transformRow(i, total);
        derivatives.add(i, i, dFdX, dFdV);
    }

    private static void addTo(double[] row, double factor, Vector3 vector) {
        row[0] += factor * vector.x();
        row[1] += factor * vector.y();
        row[2] += factor * vector.z();
    }

    private static void addProduct(double[] matrix, double factor, Vector3 column, double[] row) {
        for (int c = 0; c < 3; c++) {
            matrix[c] += factor * column.x() * row[c];
            matrix[3 + c] += factor * column.y() * row[c];
            matrix[6 + c] += factor * column.z() * row[c];
        }
    }
}
