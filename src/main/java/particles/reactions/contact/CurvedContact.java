package particles.reactions.contact;

import java.util.Arrays;
import particles.law.Vector3;

/**
 * The contribution of curvature to the derivative of the contact force on one particle. Differentiating the conditions
 * N_p . (F + sum of lambda_q N_q) = b_p with b_p = -m kappa v_t&sup2; with respect to position at constant F gives sum
 * of G_pq dlambda_q = db_p - dN_p . (F + R) - sum of lambda_q N_p . dN_q, where R is the sum of the normal forces, dN =
 * kappa P dx, P = 1 - N N<sup>T</sup>, and dkappa = -kappa&sup2; N . dx for a sphere.
 */
final class CurvedContact {
    final double[][] pushByPlace;                       // d lambda_p / dx at the same force before
    final double[][] pushByVelocity;                    // d lambda_p / dv at the same force before
    private final double[][] right = new double[3][3];
    private final double[][] rightByVelocity = new double[3][3];
    private TouchedSurfaces touched;
    private Vector3 velocity = Vector3.ZERO;
    private boolean any;

    CurvedContact(int surfaces) {
        pushByPlace = new double[surfaces][3];
        pushByVelocity = new double[surfaces][3];
    }

    /**
     * Computes the derivatives for a particle.
     *
     * @param pushing the indices of the touched surfaces that push; the first active entries are valid
     * @param inverse the inverse of G for them
     */
    void begin(TouchedSurfaces touched, double mass, double[] state, int v, int[] pushing, int active,
            double[][] inverse) {
        this.touched = touched;
        any = false;
        for (int a = 0; a < active; a++) {
            any |= touched.curvature[pushing[a]] != 0;
        }
        if (!any) {
            return;
        }
        velocity = new Vector3(state[v], state[v + 1], state[v + 2]);
        double[] left = touched.unheld();
        Vector3 total = new Vector3(left[0], left[1], left[2]);
        for (int a = 0; a < active; a++) {
            int p = pushing[a];
            double kappa = touched.curvature[p];
            Vector3 normal = touched.normals[p];
            double across = normal.dot(velocity);
            Vector3 slip = along(normal, velocity);
            Vector3 byPlace = normal.times(mass * kappa * kappa * slip.dot(slip))
                    .plus(slip.times(2 * mass * kappa * kappa * across)).plus(along(normal, total).times(-kappa));
            for (int b = 0; b < active; b++) {
                int q = pushing[b];
                byPlace = byPlace.plus(along(touched.normals[q],
                        normal).times(-touched.push[q] * touched.curvature[q]));
            }
            put(byPlace, right[a]);
            put(slip.times(-2 * mass * kappa), rightByVelocity[a]);
        }
        for (int a = 0; a < active; a++) {
            solve(inverse[a], right, active, pushByPlace[pushing[a]]);
            solve(inverse[a], rightByVelocity, active, pushByVelocity[pushing[a]]);
        }
    }

    /** Whether any surface that pushes is curved; if not, the arrays hold nothing. */
    boolean isAny() {
        return any;
    }

    /** Adds the push times the turning of its normal, lambda kappa P. */
    void addTurning(int p, double push, double[] matrix) {
        Vector3 normal = touched.normals[p];
        for (int column = 0; column < 3; column++) {
            addTo(matrix, column, along(normal, unit(column)).times(push * touched.curvature[p]));
        }
    }

    /**
     * Adds the change of the friction of surface p, -factor (v - (N . v) N), as its normal turns.
     *
     * @param unit a vector of which only the direction counts, so that changes along it do not; or 0 if its length does
     *             too
     * @param mirrored as {@link SlidingDirection#mirrored}
     */
    void addTurningOfSlip(int p, double factor, double[] unit, double[] mirrored, double[] matrix) {
        Vector3 normal = touched.normals[p];
        Vector3 direction = new Vector3(unit[0], unit[1], unit[2]);
        double square = direction.dot(direction);
        Vector3 across = new Vector3(mirrored[0], mirrored[1], mirrored[2]);
        for (int column = 0; column < 3; column++) {
            Vector3 turning = along(normal, unit(column)).times(touched.curvature[p]);
            Vector3 change = normal.times(-turning.dot(velocity)).plus(turning.times(-normal.dot(velocity)));
            change = change.plus(across.times(-2 * across.dot(change)));
            if (square > 0) {
                change = change.plus(direction.times(-direction.dot(change) / square));
            }
            addTo(matrix, column, change.times(-factor));
        }
    }

    private static Vector3 unit(int axis) {
        return new Vector3(axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0);
    }

    /** The part of a vector that lies in a surface. */
    private static Vector3 along(Vector3 normal, Vector3 vector) {
        return vector.plus(normal.times(-normal.dot(vector)));
    }

    private static void put(Vector3 vector, double[] row) {
        row[0] = vector.x();
        row[1] = vector.y();
        row[2] = vector.z();
    }

    private static void solve(double[] inverseRow, double[][] right, int active, double[] result) {
        Arrays.fill(result, 0);
        for (int b = 0; b < active; b++) {
            for (int c = 0; c < 3; c++) {
                result[c] += inverseRow[b] * right[b][c];
            }
        }
    }

    private static void addTo(double[] matrix, int column, Vector3 vector) {
        matrix[column] += vector.x();
        matrix[3 + column] += vector.y();
        matrix[6 + column] += vector.z();
    }
}
