package particles.reactions;

import deSolvers.linear.EnvelopeMatrix;
import deSolvers.linear.MinimumNormSolution;
import java.util.Arrays;

/**
 * Active-set solver of a mixed linear complementarity problem: A lambda - b = w with w = 0 in the rows of rods and
 * wires, and lambda &ge; 0, w &ge; 0, lambda w = 0 in those of contacts: a contact either pushes or separates. For
 * each active set one linear system is solved, in the envelope of A. A contact is wrong if it is active with lambda
 * &lt; 0, or inactive with w &lt; 0, but for the error of active rows that contradict each other. If fewer are wrong
 * than ever before, all of them change sides (J. J&uacute;dice, F. Pires 1994), otherwise only the one with the least
 * index (K. Murty 1974).
 *
 * <p>If rows are linearly dependent, as in a square with both diagonals, many solutions give the same motion; the one
 * with the least sum of squares is taken, the load of equal, slightly elastic rods. Where many balls are packed, a set
 * of dependent contacts may have no solution although others do. Then contacts are made slightly elastic and added one
 * by one, each as long as it pushes (C. Lawson, R. Hanson, "Solving Least Squares Problems", 1974): without friction
 * this search always ends.
 */
final class ActiveSetMethod {
    private EnvelopeMatrix a;                           // the problem, as given to solve
    private double[] b;
    private boolean[] contact;
    private boolean[] active;
    private double[] lambda;
    private double[] w;
    private int n;                                      // the number of rows
    private boolean[] wrong = {};
    private double largest;                             // entry of b
    private double left;
    private boolean regular;
    private boolean dependent;
    private double singular = Tolerances.SINGULAR;
    private double noise = Tolerances.NOISE;

    /** Sets the ratio of the largest mass to the smallest; round-off of forces grows with it. */
    void setMassRatio(double ratio) {
        singular = Math.max(Tolerances.SINGULAR / ratio, Tolerances.MOST_SINGULAR);
        noise = Tolerances.NOISE * ratio;
    }

    /** The largest residual entry of active rows, which is large if they contradict each other; 0 for round-off. */
    double getLeft() {
        return left;
    }

    /**
     * Solves the problem. Rows with a diagonal entry of 0 are left out.
     *
     * @param contact which rows are those of contacts
     * @param signed  true if contacts can only push; if false, all contacts stay active and may pull, unless the active
     *                rows are linearly dependent: then the search runs as if true
     * @param active  the contacts with which the search starts; receives those that push
     * @param lambda  receives the solution
     * @param w       receives A lambda - b
     * @return false if the search does not end, even with elastic contacts: no forces satisfy all conditions; or if
     *         rows are dependent, perhaps only by round-off of very uneven masses
     */
    boolean solve(EnvelopeMatrix a, double[] b, boolean[] contact, boolean signed, boolean[] active,
            double[] lambda, double[] w) {
        this.a = a;
        this.b = b;
        this.contact = contact;
        this.active = active;
        this.lambda = lambda;
        this.w = w;
        n = a.size();
        dependent = false;
        wrong = new boolean[n];
        largest = 0;
        for (int r = 0; r < n; r++) {
            largest = Math.max(largest, Math.abs(b[r]));
        }
        return (search(signed) || searchElastic()) && !(dependent && noise > Tolerances.NOISE * Tolerances.MOST_UNEVEN);
    }

    private boolean search(boolean signed) {
        int contacts = 0;
        for (int r = 0; r < n; r++) {
            active[r] = a.get(r, r) != 0 && (active[r] || !contact[r]);
            contacts += contact[r] ? 1 : 0;
        }
        int fewest = contacts + 1;
        for (int pivots = 0; pivots <= 50 + 20 * contacts; pivots++) {
            solveActive();
            if (contacts == 0 || !signed && pivots == 0 && regular) {
                return true;
            }
            int count = findWrong();
            if (count == 0) {
                return isConsistent();
            }
            boolean all = count < fewest;
            fewest = Math.min(fewest, count);
            for (int r = 0; r < n && count > 0; r++) {
                active[r] ^= wrong[r];
                count = wrong[r] && !all ? 0 : count;
            }
        }
        return false;
    }

    /** Whether contacts alone do not contradict each other; if rods do, no other set of contacts helps. */
    private boolean isConsistent() {
        boolean contactsAgree = true;
        boolean rodsAgree = true;
        for (int r = 0; r < n; r++) {
            boolean agrees = !active[r] || Math.abs(w[r]) <= Math.max(Tolerances.CONTRADICTION, noise) * largest;
            contactsAgree &= agrees || !contact[r];
            rodsAgree &= agrees || contact[r];
        }
        return contactsAgree || !rodsAgree;
    }

    private boolean searchElastic() {
        double[] rigid = new double[n];
        double[] pushing = new double[n];
        for (int r = 0; r < n; r++) {
            rigid[r] = a.get(r, r);
            a.set(r, r, rigid[r] * (contact[r] ? 1 + Tolerances.SOFT : 1), 0);
            active[r] = rigid[r] != 0 && !contact[r];
        }
        boolean[] barred = new boolean[n];              // from being added next
        int added = -1;
        boolean found = false;
        for (int pivots = 0; pivots <= 50 + 20 * n && !found; pivots++) {
            solveActive();
            boolean enters = added >= 0 && pushing[added] == 0;
            int dropped = dropFirst(pushing);
            if (enters && dropped == added) {
                barred[added] = true;                   // round-off: it would come and go for ever
            } else if (dropped < 0) {
                if (enters) {
                    Arrays.fill(barred, false);
                }
                added = addWorst(barred);
                found = added < 0;
            }
        }
        for (int r = 0; r < n; r++) {
            a.set(r, r, rigid[r], 0);
        }
        if (!found) {
            return false;
        }
        solveActive();
        if (findWrong() > 0 || !isConsistent()) {
            System.arraycopy(pushing, 0, lambda, 0, n);
            findResidual();
        }
        for (int r = 0; r < n; r++) {
            if (contact[r] && w[r] < -Tolerances.NO_SOLUTION * largest) {   // huge forces: contacts give way to a jam
                return false;
            }
        }
        return true;
    }

    /** Goes towards a solution until the first contact would pull, which is dropped; returns it, or -1. */
    private int dropFirst(double[] pushing) {
        double part = 1;
        int first = -1;
        for (int r = 0; r < n; r++) {
            if (contact[r] && active[r] && lambda[r] < 0 && pushing[r] <= part * (pushing[r] - lambda[r])) {
                part = pushing[r] / (pushing[r] - lambda[r]);
                first = r;
            }
        }
        for (int r = 0; r < n; r++) {
            pushing[r] = r == first ? 0 : pushing[r] + part * (lambda[r] - pushing[r]);
            active[r] &= r != first;
        }
        return first;
    }

    /** Adds the contact that lets its particle in fastest, but for barred ones; returns it, or -1. */
    private int addWorst(boolean[] barred) {
        int worst = -1;
        for (int r = 0; r < n; r++) {
            if (contact[r] && !active[r] && !barred[r] && w[r] < (worst < 0 ? -Tolerances.PULL * largest : w[worst])) {
                worst = r;
            }
        }
        if (worst >= 0) {
            active[worst] = true;
        }
        return worst;
    }

    /** Finds the contacts that pull or let their particle in; returns their number. */
    private int findWrong() {
        double force = 0;
        for (int r = 0; r < n; r++) {
            force = Math.max(force, Math.abs(lambda[r]));
        }
        int count = 0;
        for (int r = 0; r < n; r++) {
            wrong[r] = contact[r] && (active[r] ? lambda[r] < -Tolerances.PULL * force
                    : w[r] < -Math.max(Tolerances.PULL, noise) * largest - left);
            count += wrong[r] ? 1 : 0;
        }
        return count;
    }

    private void solveActive() {
        for (int r = 0; r < n; r++) {
            lambda[r] = active[r] ? b[r] : 0;
        }
        regular = a.factorise(active, singular);
        dependent |= !regular;
        if (regular) {
            a.solve(lambda);
            findResidual();
        }
        if (regular && left <= Math.max(Tolerances.RESIDUAL, noise) * largest) {
            left = 0;
        } else {
            MinimumNormSolution.solve(a, active, b, lambda, singular);
            findResidual();
        }
    }

    private void findResidual() {
        a.residual(lambda, b, w);
        left = 0;
        for (int r = 0; r < n; r++) {
            left = active[r] ? Math.max(left, Math.abs(w[r])) : left;
        }
    }
}
