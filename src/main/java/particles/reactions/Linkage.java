package particles.reactions;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import particles.law.Particles;
import particles.reactions.algebra.EnvelopeCholesky;
import particles.reactions.algebra.MinimumNormSolution;

/**
 * A connected set of rods and beads; solves A lambda = b with A = J W J<sup>T</sup>, W the inverse masses. A has an
 * entry wherever two rows share a movable particle. For a chain it is tridiagonal, and the time is proportional to its
 * length.
 *
 * <p>If rows are linearly dependent, as in a square with both diagonals, many solutions give the same motion; the one
 * with the least sum of squares is taken, the load of equal, slightly elastic rods.
 */
final class Linkage {
    /**
     * Pivots below this fraction of a diagonal entry are round-off: rows within an angle of 3e-6 of being dependent.
     */
    private static final double SINGULAR = 1e-11;

    private final ConstraintRows rows;
    private final Particles all;
    private final int[] members;                        // the rows, in the matrix's order
    private final int[] particles;
    private final int[] pairs;                          // five ints each: see findPairs
    private final EnvelopeCholesky cholesky;
    private final double[] work;
    private final MinimumNormSolution minimumNorm = new MinimumNormSolution();
    private boolean regular;

    Linkage(ConstraintRows rows, int[] members, Particles all) {
        this.rows = rows;
        this.all = all;
        this.members = members;
        particles = Arrays.stream(members).flatMap(r -> IntStream.of(rows.first(r), rows.second(r)))
                .filter(i -> i >= 0 && !all.isFixed(i)).distinct().sorted().toArray();
        work = new double[members.length];
        List<int[]> found = new ArrayList<>();
        int[] firstColumn = new int[members.length];
        for (int r = 0; r < members.length; r++) {
            firstColumn[r] = r;
            for (int c = r; c >= 0; c--) {
                if (findPairs(r, c, found)) {
                    firstColumn[r] = c;
                }
            }
        }
        pairs = found.stream().flatMapToInt(Arrays::stream).toArray();
        cholesky = new EnvelopeCholesky(firstColumn);
    }

    /** Records each particle that two rows share: row, column, the indices of its gradients in both, the particle. */
    private boolean findPairs(int r, int c, List<int[]> found) {
        int before = found.size();
        int a = members[r];
        int b = members[c];
        int[] mine = {rows.first(a), rows.second(a)};
        int[] theirs = {rows.first(b), rows.second(b)};
        for (int k = 0; k < 2; k++) {
            for (int l = 0; l < 2; l++) {
                if (mine[k] >= 0 && mine[k] == theirs[l]) {
                    found.add(new int[] {r, c, 6 * a + 3 * k, 6 * b + 3 * l, mine[k]});
                }
            }
        }
        return found.size() > before;
    }

    /** The particles of the linkage that can move. */
    int[] particles() {
        return particles;
    }

    int[] members() {
        return members;
    }

    /**
     * Whether a moving anchor drives a rod, so that friction cannot hold the rod's other end.
     *
     * @param particle      the other end; -1 for any
     * @param accelerations the accelerations of moving anchors (m/s&sup2;), in the entries of their velocities
     */
    boolean isDriven(int particle, double[] state, double[] accelerations) {
        for (int row : members) {
            if ((particle < 0 || rows.first(row) == particle || rows.second(row) == particle)
                    && rows.isDraggedByAnchor(row, state, accelerations, all.getInverseMasses())) {
                return true;
            }
        }
        return false;
    }

    /** Factorises A for the present gradients. @param mobility 1/m of each particle, 0 for fixed ones */
    void factorise(double[] mobility) {
        assemble(mobility);
        regular = cholesky.factorise(SINGULAR);
        if (!regular) {
            assemble(mobility);
            int n = members.length;
            minimumNorm.begin(n);
            for (int r = 0; r < n; r++) {
                for (int c = 0; c <= r; c++) {
                    minimumNorm.set(r, c, cholesky.get(r, c));
                    minimumNorm.set(c, r, cholesky.get(r, c));
                }
            }
            minimumNorm.factorise();
        }
    }

    private void assemble(double[] mobility) {
        cholesky.clear();
        double[] gradient = rows.gradient;
        for (int p = 0; p < pairs.length; p += 5) {
            int g = pairs[p + 2];
            int h = pairs[p + 3];
            cholesky.add(pairs[p], pairs[p + 1], mobility[pairs[p + 4]] * (gradient[g] * gradient[h]
                    + gradient[g + 1] * gradient[h + 1] + gradient[g + 2] * gradient[h + 2]));
        }
    }

    /**
     * Solves A lambda = b.
     *
     * @param right  b, indexed by all rows
     * @param result receives lambda, indexed by all rows
     * @return the largest entry of the residual: 0 if there is a solution, more if the rows contradict each other
     */
    double solve(double[] right, double[] result) {
        for (int r = 0; r < members.length; r++) {
            work[r] = right[members[r]];
        }
        double left = 0;
        if (regular) {
            cholesky.solve(work);
        } else {
            left = minimumNorm.solve(work);
        }
        for (int r = 0; r < members.length; r++) {
            result[members[r]] = work[r];
        }
        return left;
    }

    /**
     * The scale to which a residual is compared. In free fall the right-hand side is only round-off of forces, whose
     * size follows from the accelerations.
     *
     * @param right         b, indexed by all rows
     * @param accelerations the particles' accelerations without these forces (m/s&sup2;), in the entries of the
     *                      velocities
     * @return the largest entry of either
     */
    double scale(double[] right, double[] accelerations) {
        double largest = 0;
        for (int row : members) {
            largest = Math.max(largest, Math.abs(right[row]));
        }
        for (int i : particles) {
            for (int a = Particles.STRIDE * i + 3; a < Particles.STRIDE * (i + 1); a++) {
                largest = Math.max(largest, Math.abs(accelerations[a]));
            }
        }
        return largest;
    }
}
