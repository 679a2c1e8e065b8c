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
            derivative.add(state, this, s, derivatives);
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
}
