package particles.effects;

import deSolvers.ForceDerivatives;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import particles.law.BriefForce;
import particles.law.DifferentiableEffect;
import particles.law.Particles;
import particles.law.Vector3;

/**
 * Base class of central forces between particles. With r = x_i - x_j, the force on particle i of a pair is
 * <pre>
 *   F_i = s r,     s a function of |r|&sup2; and r . r'
 * </pre>
 * and F_j = -F_i, so momentum and angular momentum are conserved. A subclass knows s, its derivatives, and which
 * particles are near. Not thread-safe, except where a subclass says so.
 */
abstract class PairForce implements DifferentiableEffect, BriefForce {
    static final int STRIDE = Particles.STRIDE;

    final Particles particles;
    private final boolean damped;
    /** The candidates for neighbours; those of a particle are in a row. */
    int[] near = {};
    private final double[] r = new double[3];
    final double[] w = new double[3];
    private final double[] dFdX = new double[9];
    private final double[] dFdV = new double[9];

    /**
     * @param particles the particles on which it acts
     * @param damped    whether s depends on r . r', and so loses energy
     */
    PairForce(Particles particles, boolean damped) {
        this.particles = particles;
        this.damped = damped;
    }

    /** Prepares the candidates of all particles. */
    abstract void findNeighbours(double[] state);

    /** Where the candidates of a particle begin in {@link #near}: all of them, or those with a larger index. */
    abstract int first(int i, boolean all);

    /** Where they end. */
    abstract int end(int i);

    /** Whether a pair at this squared distance is near enough to act on each other. */
    abstract boolean reaches(int i, int j, double square);

    /** s (N/m) of a pair in reach, whose r . r' is parting. */
    abstract double perLength(int i, int j, double square, double parting);

    /** The energy that it stores (J). */
    abstract double potential(int i, int j, double square);

    /** The derivative of s with respect to |r|&sup2; (N/m&sup3;). */
    abstract double bySquare(int i, int j, double square, double parting);

    /** The derivative of s with respect to r . r' (N s/m&sup3;). */
    abstract double byParting(int i, int j, double square, double parting);

    @Override
    public final Set<Trait> getTraits() {
        return Set.of(Trait.INTERNAL, Trait.TRANSLATION_INVARIANT, Trait.ROTATION_INVARIANT,
                damped ? Trait.DISSIPATIVE : Trait.CONSERVATIVE);
    }

    @Override
    public final boolean dependsOnVelocity() {
        return damped;
    }

    /** Finds a particle, from this index on, at the place of another; pairs of fixed ones do not count. */
    final Optional<String> findAtOnePlace(double[] state, int first) {
        Map<Vector3, Integer> places = new HashMap<>();
        for (int i = 0; i < particles.count(); i++) {
            Vector3 place = Vector3.at(state, STRIDE * i).plus(Vector3.ZERO);       // -0 becomes 0
            Integer other = places.put(place, i);
            if (other != null && i >= first && !(particles.isFixed(i) && particles.isFixed(other))) {
                return Optional.of("'" + particles.id(other) + "' and '" + particles.id(i)
                        + "' are at the same place");
            }
        }
        return Optional.empty();
    }

    @Override
    public final void addForces(double[] state, double time, double[] force) {
        findNeighbours(state);
        add(state, force, 0, particles.count(), false);
    }

    /**
     * Adds the forces on particles from ... to - 1. With {@code all}, each gets the forces of all its neighbours;
     * otherwise each pair is evaluated once, and its force added to both. If candidates are sorted by index, the sums
     * are the same, bit for bit.
     */
    final void add(double[] state, double[] force, int from, int to, boolean all) {
        for (int p = from; p < to; p++) {
            int i = STRIDE * p;
            double x = state[i];
            double y = state[i + 1];
            double z = state[i + 2];
            double fx = force[i + 3];
            double fy = force[i + 4];
            double fz = force[i + 5];
            int end = end(p);
            for (int k = first(p, all); k < end; k++) {
                int j = STRIDE * near[k];
                double rx = x - state[j];
                double ry = y - state[j + 1];
                double rz = z - state[j + 2];
                double square = rx * rx + ry * ry + rz * rz;
                if (!reaches(p, near[k], square)) {
                    continue;
                }
                double parting = !damped ? 0 : rx * (state[i + 3] - state[j + 3])
                        + ry * (state[i + 4] - state[j + 4]) + rz * (state[i + 5] - state[j + 5]);
                double perLength = perLength(p, near[k], square, parting);
                fx += perLength * rx;
                fy += perLength * ry;
                fz += perLength * rz;
                if (!all) {
                    force[j + 3] -= perLength * rx;
                    force[j + 4] -= perLength * ry;
                    force[j + 5] -= perLength * rz;
                }
            }
            force[i + 3] = fx;
            force[i + 4] = fy;
            force[i + 5] = fz;
        }
    }

    @Override
    public final void addForceDerivatives(double[] state, double time, ForceDerivatives derivatives) {
        forEachPair(state, (i, j, square, parting) -> {
            double straight = perLength(i, j, square, parting);
            double outer = 2 * bySquare(i, j, square, parting);
            double drag = byParting(i, j, square, parting);
            for (int e = 0; e < 9; e++) {
                dFdX[e] = (e % 4 == 0 ? straight : 0) + r[e / 3] * (outer * r[e % 3] + drag * w[e % 3]);
                dFdV[e] = drag * r[e / 3] * r[e % 3];
            }
            derivatives.addPair(i, j, dFdX, dFdV);
        });
    }

    @Override
    public final double getPotentialEnergy(double[] state, double time) {
        findNeighbours(state);
        double energy = 0;
        for (int i = 0; i < particles.count(); i++) {
            int end = end(i);
            for (int k = first(i, false); k < end; k++) {
                double square = square(state, STRIDE * i, STRIDE * near[k]);
                energy += reaches(i, near[k], square) ? potential(i, near[k], square) : 0;
            }
        }
        return energy;
    }

    /** {@inheritDoc} The rate at which the potential falls minus the power on the particles. */
    @Override
    public final double getDissipatedPower(double[] state, double time) {
        double[] sum = new double[1];
        if (damped) {
            forEachPair(state, (i, j, square, parting) -> sum[0] += parting
                    * (perLength(i, j, square, 0) - perLength(i, j, square, parting)));
        }
        return sum[0];
    }

    private static double square(double[] state, int i, int j) {
        double rx = state[i] - state[j];
        double ry = state[i + 1] - state[j + 1];
        double rz = state[i + 2] - state[j + 2];
        return rx * rx + ry * ry + rz * rz;
    }

    /** Something to do with a pair in reach. */
    interface PairVisitor {
        void visit(int i, int j, double square, double parting);
    }

    /** Visits each pair in reach once, with r and r' in the arrays. */
    final void forEachPair(double[] state, PairVisitor visitor) {
        findNeighbours(state);
        for (int p = 0; p < particles.count(); p++) {
            int i = STRIDE * p;
            int end = end(p);
            for (int k = first(p, false); k < end; k++) {
                int j = STRIDE * near[k];
                double rx = state[i] - state[j];
                double ry = state[i + 1] - state[j + 1];
                double rz = state[i + 2] - state[j + 2];
                double square = rx * rx + ry * ry + rz * rz;
                if (!reaches(p, near[k], square)) {
                    continue;
                }
                r[0] = rx;
                r[1] = ry;
                r[2] = rz;
                w[0] = state[i + 3] - state[j + 3];
                w[1] = state[i + 4] - state[j + 4];
                w[2] = state[i + 5] - state[j + 5];
                visitor.visit(p, near[k], square, rx * w[0] + ry * w[1] + rz * w[2]);
            }
        }
    }
}
