package deSolvers.implicit;

import deSolvers.ForceDerivatives;
import deSolvers.JacobianStateSource;
import deSolvers.problems.SecondOrderProblem;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;

/**
 * Particles in space in a chain with loops, on which K (x_j - x_i) + C (v_j - v_i) acts between neighbours and a
 * spring -(1 + t) x^3 on each by itself, entry by entry; the second one is held. All their derivatives are known.
 */
final class BlockParticles extends SecondOrderProblem implements JacobianStateSource {
    private record Pair(int i, int j, double[] k, double[] c) {
    }

    private final List<Pair> pairs = new ArrayList<>();
    private final double[] masses;
    private final double[] start;
    private final boolean exact;
    final double stiffness;
    double cubic = 1;

    /**
     * @param stiffness how large the entries of K may be, those of C are a tenth of that; K is definite and symmetric,
     *                  and pushes outwards where this is negative
     * @param symmetric whether C is, too
     * @param exact     whether the blocks are; others leave out the hard springs and a tenth of the rest
     */
    BlockParticles(int n, double stiffness, boolean symmetric, boolean exact) {
        super(3, new double[6 * n]);
        this.exact = exact;
        this.stiffness = stiffness;
        Random random = new Random(n);
        masses = random.doubles(n, 0.5, 20).toArray();
        if (n > 0) {
            masses[0] = 3;                              // its reciprocal's reciprocal is 3 to the bit
            masses[held()] = 0;
        }
        for (int i = 0; i + 1 < n; i++) {
            pairs.add(pair(i, i + 1, stiffness, symmetric, random));
            if (i % 5 == 0 && i + 4 < n) {
                pairs.add(pair(i, i + 4, stiffness, symmetric, random));
            }
        }
        start = random.doubles(6L * n, -1, 1).toArray();
        for (int e = 3; e < 6 && n > 0; e++) {
            start[6 * held() + e] = 0;
        }
        startAt(0);
    }

    private static Pair pair(int i, int j, double stiffness, boolean symmetric, Random random) {
        double[] along = random.doubles(3, -1, 1).toArray();
        double[] k = new double[9];
        double[] c = new double[9];
        for (int e = 0; e < 9; e++) {
            k[e] = stiffness * (along[e / 3] * along[e % 3] + (e % 4 == 0 ? 0.1 : 0));
            c[e] = 0.1 * (symmetric ? Math.abs(stiffness) * along[e / 3] * along[e % 3]
                    : stiffness * random.nextDouble());
        }
        return new Pair(i, j, k, c);
    }

    private int held() {
        return Math.min(1, masses.length - 1);
    }

    private double hardness() {
        return cubic * (1 + getTime());
    }

    double mass(int i) {
        return masses[i];
    }

    /** For each row the sum of |dF/dx| |x| of all springs between particles: what rounding of forces is measured by. */
    double[] forceScale(double[] s) {
        double[] scale = new double[start.length / 2];
        for (Pair p : pairs) {
            for (int e = 0; e < 9; e++) {
                double part = Math.abs(p.k[e]) * (Math.abs(s[6 * p.i + e % 3]) + Math.abs(s[6 * p.j + e % 3]));
                scale[3 * p.i + e / 3] += part;
                scale[3 * p.j + e / 3] += part;
            }
        }
        for (int i = 0; i < scale.length; i++) {
            double x = s[6 * (i / 3) + i % 3];
            scale[i] += 3 * hardness() * x * x * Math.abs(x);
        }
        return scale;
    }

    @Override
    public double[] exactState(double t) {
        return start.clone();                           // only where it starts
    }

    @Override
    protected void accelerate(double t, double[] s, double[] dSdt) {
        forces(s, s, false, dSdt);
    }

    /** The accelerations, of the state or of a direction from it. */
    private void forces(double[] s, double[] w, boolean derivative, double[] dSdt) {
        for (int i = 0; i < masses.length; i++) {
            Arrays.fill(dSdt, 6 * i + 3, 6 * i + 6, 0);
        }
        for (Pair p : pairs) {
            for (int e = 0; e < 9; e++) {
                double f = p.k[e] * (w[6 * p.j + e % 3] - w[6 * p.i + e % 3])
                        + p.c[e] * (w[6 * p.j + 3 + e % 3] - w[6 * p.i + 3 + e % 3]);
                dSdt[6 * p.i + 3 + e / 3] += f;
                dSdt[6 * p.j + 3 + e / 3] -= f;
            }
        }
        for (int i = 0; i < masses.length; i++) {
            for (int c = 6 * i; c < 6 * i + 3; c++) {
                dSdt[c + 3] -= hardness() * (derivative ? 3 * s[c] * s[c] * w[c] : s[c] * s[c] * s[c]);
                dSdt[c + 3] *= getInverseMass(i);
            }
        }
    }

    /** J w, as known on paper. */
    void multiply(double[] direction, double[] product) {
        for (int x = 0; x < direction.length; x += 6) {
            System.arraycopy(direction, x + 3, product, x, 3);
        }
        forces(getState(), direction, true, product);
    }

    @Override
    public boolean hasExactJacobian() {
        return exact;
    }

    @Override
    public void addJacobianBlocks(ForceDerivatives receiver) {
        double part = exact ? -1 : -0.9;
        double[] k = new double[9];
        double[] c = new double[9];
        for (Pair p : pairs) {
            Arrays.setAll(k, e -> part * p.k[e]);
            Arrays.setAll(c, e -> part * p.c[e]);
            receiver.addPair(p.i, p.j, k, c);
        }
        double[] s = getState();
        for (int i = 0; i < masses.length && exact; i++) {
            int at = 6 * i;
            Arrays.setAll(k, e -> e % 4 == 0 ? -3 * hardness() * s[at + e / 4] * s[at + e / 4] : 0);
            receiver.add(i, i, k, new double[9]);
        }
    }

    @Override
    public double getInverseMass(int i) {
        return masses[i] == 0 ? 0 : 1 / masses[i];
    }
}
