package particles.reactions.contact;

import java.util.Arrays;
import particles.law.Vector3;

/**
 * The normal forces of several surfaces on one particle under a force F: lambda_p &ge; 0 with N_p . (F + sum of
 * lambda_q N_q) &ge; b_p, where at least one of the two is an equality. b_p is 0 for a plane and the centripetal term
 * for a curved surface. In space three surfaces are enough to hold a particle, so sets of one, two and three surfaces
 * are tried in turn; each is a small linear system.
 */
public final class NormalForces {
    /** Round-off, relative to the force. */
    private static final double TOLERANCE = 1e-12;
    /** Planes whose normals are so nearly dependent are covered by a smaller set. */
    private static final double SINGULAR = 1e-12;

    private final double[] needed;                      // b_p - N_p . F
    private final double[] trial;
    private final int[] chosen = new int[3];

    NormalForces(int surfaces) {
        needed = new double[surfaces];
        trial = new double[surfaces];
    }

    /**
     * @param count   the number of surfaces that touch the particle
     * @param normals their unit normals; the first count are valid
     * @param force   F, a vector
     * @param bound   the b_p (N)
     * @param push    receives the lambdas (N)
     */
    void solve(int count, Vector3[] normals, double[] force, double[] bound, double[] push) {
        double scale = 0;
        for (int p = 0; p < count; p++) {
            needed[p] = bound[p] - (normals[p].x() * force[0] + normals[p].y() * force[1] + normals[p].z() * force[2]);
            scale = Math.max(scale, Math.abs(needed[p]));
        }
        if (count == 1) {
            push[0] = Math.max(0, needed[0]);
            return;
        }
        double best = Double.POSITIVE_INFINITY;
        for (int size = 0; size <= Math.min(3, count) && best > TOLERANCE * scale; size++) {
            best = Math.min(best, trySets(size, 0, 0, count, normals, push, best, TOLERANCE * scale));
        }
    }

    /**
     * Tries all sets that extend the surfaces chosen so far; keeps in push the one that violates the conditions least.
     */
    private double trySets(int size, int depth, int first, int count, Vector3[] normals, double[] push, double best,
                           double enough) {
        double least = best;
        if (depth == size) {
            double violation = violation(size, count, normals);
            if (violation < least) {
                System.arraycopy(trial, 0, push, 0, count);
            }
            return Math.min(violation, least);
        }
        for (int p = first; p < count && least > enough; p++) {
            chosen[depth] = p;
            least = trySets(size, depth + 1, p + 1, count, normals, push, least, enough);
        }
        return least;
    }

    /** Solves for the chosen surfaces' normal forces; returns the largest violation of any condition (N). */
    private double violation(int size, int count, Vector3[] normals) {
        Arrays.fill(trial, 0, count, 0.0);
        if (!solveChosen(size, normals)) {
            return Double.POSITIVE_INFINITY;
        }
        double worst = 0;
        for (int p = 0; p < count; p++) {
            double approach = needed[p];                // the force still pressing into surface p
            for (int q = 0; q < size; q++) {
                approach -= normals[p].dot(normals[chosen[q]]) * trial[chosen[q]];
            }
            worst = Math.max(worst, Math.max(approach, -trial[p]));
        }
        return worst;
    }

    /**
     * The normal forces that make the conditions of the chosen surfaces equalities, by Cramer's rule on their matrix of
     * scalar products.
     */
    private boolean solveChosen(int size, Vector3[] normals) {
        if (size == 0) {
            return true;
        }
        Vector3 a = normals[chosen[0]];
        double fa = needed[chosen[0]];
        if (size == 1) {
            trial[chosen[0]] = fa;
            return true;
        }
        Vector3 b = normals[chosen[1]];
        double fb = needed[chosen[1]];
        double ab = a.dot(b);
        if (size == 2) {
            double det = 1 - ab * ab;
            trial[chosen[0]] = (fa - ab * fb) / det;
            trial[chosen[1]] = (fb - ab * fa) / det;
            return det > SINGULAR;
        }
        Vector3 c = normals[chosen[2]];
        double fc = needed[chosen[2]];
        double ac = a.dot(c);
        double bc = b.dot(c);
        double det = 1 + 2 * ab * ac * bc - ab * ab - ac * ac - bc * bc;
        trial[chosen[0]] = (fa * (1 - bc * bc) + fb * (ac * bc - ab) + fc * (ab * bc - ac)) / det;
        trial[chosen[1]] = (fa * (ac * bc - ab) + fb * (1 - ac * ac) + fc * (ab * ac - bc)) / det;
        trial[chosen[2]] = (fa * (ab * bc - ac) + fb * (ab * ac - bc) + fc * (1 - ab * ab)) / det;
        return det > SINGULAR;
    }
}
