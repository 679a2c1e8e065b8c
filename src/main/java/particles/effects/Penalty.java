package particles.effects;

import deSolvers.ForceDerivatives;
import java.util.Set;
import particles.law.DifferentiableEffect;
import particles.law.Particles;
import particles.law.PerParticleEffect;

/**
 * Base class for penalty forces: a particle at depth d inside a solid is pushed out along the surface normal N,
 * <pre>
 *   F = k d max(0, 1 - b v_n) N        for d &gt; 0
 * </pre>
 * v_n = N . v, k stiffness, b bounce loss. The force is continuous, never pulls, and stores k d&sup2;/2. It does not
 * stop particles at the surface: they enter the solid a little.
 *
 * <p>Source of the damping: K. Hunt, F. Crossley, "Coefficient of restitution interpreted as damping in vibroimpact"
 * (1975).
 */
abstract class Penalty implements PerParticleEffect, DifferentiableEffect {
    static final int STRIDE = Particles.STRIDE;

    final Particles particles;
    final double stiffness;
    final double loss;
    private final double[] normal = new double[3];
    private final double[] turning = new double[3];
    private final double[] dFdX = new double[9];
    private final double[] dFdV = new double[9];

    Penalty(Particles particles, double stiffness, double loss) {
        if (!(stiffness >= 0 && stiffness <= Double.MAX_VALUE && loss >= 0 && loss <= Double.MAX_VALUE)) {
            throw new IllegalArgumentException("a penalty's stiffness and loss have to be 0 or more and finite, not "
                    + stiffness
                    + ", " + loss);
        }
        this.particles = particles;
        this.stiffness = stiffness;
        this.loss = loss;
    }

    /** Writes the surface normal at particle i and returns the depth, negative outside. */
    abstract double depth(double[] state, int i, double[] normal);

    /** Curvature of the surface (1/m), 0 for a plane: dN/dx = curvature (1 - N N^T). */
    abstract double curvature(double[] state, int i);

    /** The push along the normal (N) for d > 0. */
    final double push(double depth, double normalSpeed) {
        return stiffness * depth * Math.max(0, 1 - loss * normalSpeed);
    }

    @Override
    public final Set<Trait> getTraits() {
        return Set.of(loss > 0 ? Trait.DISSIPATIVE : Trait.CONSERVATIVE);
    }

    @Override
    public final boolean dependsOnVelocity() {
        return loss > 0;
    }

    @Override
    public final double getPotentialEnergy(double[] state, double time) {
        double energy = 0;
        for (int i = 0; i < particles.count(); i++) {
            double depth = particles.isFixed(i) ? 0 : Math.max(0, depth(state, i, normal));
            energy += stiffness * depth * depth / 2;
        }
        return energy;
    }

    /** {@inheritDoc} The rate at which the potential falls minus the power on the particle. */
    @Override
    public final double getDissipatedPower(double[] state, double time) {
        double power = 0;
        for (int i = 0; loss > 0 && i < particles.count(); i++) {
            double depth = particles.isFixed(i) ? 0 : depth(state, i, normal);
            if (depth > 0) {
                double speed = normalSpeed(state, i, normal);
                power += speed * (stiffness * depth - push(depth, speed));
            }
        }
        return power;
    }

    private static double normalSpeed(double[] state, int i, double[] normal) {
        int v = STRIDE * i + 3;
        return normal[0] * state[v] + normal[1] * state[v + 1] + normal[2] * state[v + 2];
    }

    @Override
    public final void addForceDerivatives(double[] state, double time, ForceDerivatives derivatives) {
        for (int i = 0; i < particles.count(); i++) {
            double depth = depth(state, i, normal);
            if (!(depth > 0)) {
                continue;
            }
            double speed = normalSpeed(state, i, normal);
            double push = push(depth, speed);
            double bySpeed = push > 0 ? -stiffness * depth * loss : 0;
            double curvature = curvature(state, i);
            for (int c = 0; c < 3; c++) {               // d(push)/dx = -dpush/dd N + ...
                turning[c] = -push / depth * normal[c]
                        + bySpeed * curvature * (state[STRIDE * i + 3 + c] - speed * normal[c]);
            }
            for (int e = 0; e < 9; e++) {
                dFdX[e] = normal[e / 3] * turning[e % 3]
                        + push * curvature * ((e % 4 == 0 ? 1 : 0) - normal[e / 3] * normal[e % 3]);
                dFdV[e] = bySpeed * normal[e / 3] * normal[e % 3];
            }
            derivatives.add(i, i, dFdX, dFdV);
        }
    }
}
