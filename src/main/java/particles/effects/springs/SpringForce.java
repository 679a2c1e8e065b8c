package particles.effects.springs;

import deSolvers.ForceDerivatives;
import java.util.Set;
import particles.law.DifferentiableEffect;
import particles.law.DivisibleEffect;
import particles.law.Particles;
import particles.law.Require;

/**
 * Damped springs between pairs of particles, the slides' "Damped Spring Force": on particle i, due to j,
 * <pre>
 *   r = x_j - x_i,   r' = v_j - v_i
 *   F_ij = [ k (|r| - l) + k_d (r . r') / |r| ] r / |r|,     F_ji = -F_ij
 * </pre>
 * k stiffness, l rest length, k_d damping. (Our copy of the slide has r' = v_i - v_i.)
 *
 * <p>A spring between two particles at the same place has no direction and exerts no force. For l = 0 that is the limit
 * of the law; for l &gt; 0 it is an unstable equilibrium.
 *
 * <p>Spring indices are in the order of adding until forces are first evaluated; then springs are sorted by their first
 * particle. Indices become invalid when springs are added or removed.
 *
 * <p>Potential energy k (|r| - l)&sup2; / 2, dissipated power k_d (d|r|/dt)&sup2;. Source: COMPSCI 715 (2003), slides
 * "Spring Force" and "Damped Spring Force".
 */
public final class SpringForce extends SpringTable implements DivisibleEffect, DifferentiableEffect {
    private final Particles particles;
    private boolean damped;
    private final SpringJacobian derivative = new SpringJacobian();

    /** @param particles the particles that springs can connect */
    public SpringForce(Particles particles) {
        this.particles = particles;
    }

    /**
     * Adds a spring.
     *
     * @param i          the index of the particle at its first end
     * @param j          the index of the particle at its second end, not i
     * @param stiffness  k (N/m), 0 or more
     * @param restLength l (m), 0 or more
     * @param damping    k_d (N s/m), 0 or more
     * @throws IllegalArgumentException if a number is out of its range, or i = j
     */
    public void addSpring(int i, int j, double stiffness, double restLength, double damping) {
        int n = particles.count();
        if (i < 0 || i >= n || j < 0 || j >= n) {
            throw new IllegalArgumentException("a spring between particles " + i + " and " + j + "; there are " + n);
        }
        if (i == j) {
            throw new IllegalArgumentException("a spring from particle '" + particles.id(i) + "' to itself");
        }
        Require.notNegative("a spring's stiffness", stiffness);
        Require.notNegative("a spring's rest length", restLength);
        Require.notNegative("a spring's damping", damping);
        add(i, j, stiffness, restLength, damping);
        damped |= damping > 0;
    }

    @Override
    public String getName() {
        return "springs";
    }

    @Override
    public Set<Trait> getTraits() {
        return Set.of(Trait.INTERNAL, Trait.TRANSLATION_INVARIANT, Trait.ROTATION_INVARIANT,
                damped ? Trait.DISSIPATIVE : Trait.CONSERVATIVE);
    }

    @Override
    public boolean dependsOnVelocity() {
        return damped;
    }

    @Override
    public void addPart(int part, double[] state, double time, double[] force) {
        SpringKernel.addForces(this, state, force, getPartStart(part), getPartStart(part + 1));
    }

    @Override
    public void addForces(double[] state, double time, double[] force) {
        int blocks = countBlocks();
        for (int part = 0; part <= blocks; part++) {
            addPart(part, state, time, force);
        }
    }

    @Override
    public void addForceDerivatives(double[] state, double time, ForceDerivatives derivatives) {
        for (int s = 0; s < count; s++) {
            derivative.add(state, s, derivatives);
        }
    }

    @Override
    public double getPotentialEnergy(double[] state, double time) {
        double energy = 0;
        for (int s = 0; s < count; s++) {
            double stretch = length(state, s) - restLength[s];
            energy += stiffness[s] * stretch * stretch / 2;
        }
        return energy;
    }

    @Override
    public double getDissipatedPower(double[] state, double time) {
        double power = 0;
        for (int s = 0; damped && s < count; s++) {
            if (damping[s] > 0) {
                double rate = lengthRate(state, s);
                power += damping[s] * rate * rate;
            }
        }
        return power;
    }

    /**
     * The derivative of a damped spring's force. With u = r/|r|, w = r' and the tension tau = k (|r| - l) + k_d (u .
     * w):
     * <pre>
     *   dF_ij/dr  = k u u^T + tau/|r| (1 - u u^T) + k_d/|r| u (w - (u . w) u)^T
     *   dF_ij/dr' = k_d u u^T
     * </pre> and dF_ij/dx_i = -dF_ij/dr. The second term is negative for a compressed spring, which tends to buckle.
     * The last one is not symmetric; it appears when a damped spring rotates.
     *
     * <p>Source: derived from the slide "Damped Spring Force"; for l = 0 or k_d = 0 as in D. Baraff, A. Witkin (1998).
     */
    private final class SpringJacobian {
        /** The direction of shorter springs is only round-off. */
        private static final double SHORTEST = 1e-140;

        private final double[] dFdX = new double[9];
        private final double[] dFdV = new double[9];
        private final double[] u = new double[3];
        private final double[] turning = new double[3];

        /** Adds the blocks of spring {@code s}. */
        void add(double[] state, int s, ForceDerivatives derivatives) {
            int i = from[s];                                // F_ij acts on this particle; its state index
            int j = to[s];
            double k = stiffness[s];
            double kd = damping[s];
            double length = direction(state, i, j);
            // without direction: as for rest length 0
            double across = -k;
            double along = 0;
            double drag = 0;
            if (length > 0) {
                double stretching = 0;
                for (int c = 0; c < 3; c++) {
                    turning[c] = state[j + 3 + c] - state[i + 3 + c];
                    stretching += u[c] * turning[c];
                }
                for (int c = 0; c < 3; c++) {
                    turning[c] = kd * (turning[c] - stretching * u[c]) / length;
                }
                across = -(k * (length - restLength[s]) + kd * stretching) / length;
                along = -k - across;
                drag = -kd;
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
}
