package particles.effects;

import java.util.EnumSet;
import java.util.Optional;
import java.util.Set;
import particles.Effect;
import particles.LinearLaw;
import particles.Particles;
import particles.Vector3;

/**
 * Uniform gravity, the slides' "gravitational acceleration rule": F = m g on every particle.
 *
 * <p>Potential energy -m g . x, zero at the origin. Source: COMPSCI 715 (2003), slides "A Particle System" and
 * "Mass-Spring System (cont'd)".
 */
public final class Gravity implements Effect {
    private static final int STRIDE = Particles.STRIDE;

    private final Particles particles;
    private final double gx;
    private final double gy;
    private final double gz;
    private final Optional<LinearLaw> linearLaw;

    /**
     * @param particles    on whom it acts
     * @param acceleration g (m/s&sup2;), such as (0, -9.81, 0)
     * @throws IllegalArgumentException if g is not finite
     */
    public Gravity(Particles particles, Vector3 acceleration) {
        if (!acceleration.isFinite()) {
            throw new IllegalArgumentException("gravity has to be finite, not " + acceleration);
        }
        this.particles = particles;
        gx = acceleration.x();
        gy = acceleration.y();
        gz = acceleration.z();
        linearLaw = Optional.of(new LinearLaw(gx, gy, gz, 0));
    }

    @Override
    public String getName() {
        return "gravity";
    }

    @Override
    public Set<Trait> getTraits() {
        return EnumSet.of(Trait.CONSERVATIVE, Trait.TRANSLATION_INVARIANT);
    }

    @Override
    public int size() {
        return particles.count();
    }

    @Override
    public boolean isPerParticle() {
        return true;
    }

    @Override
    public Optional<LinearLaw> getLinearLaw() {
        return linearLaw;
    }

    @Override
    public boolean isConcurrent() {
        return true;
    }

    @Override
    public boolean dependsOnVelocity() {
        return false;
    }

    /** {@inheritDoc} There are none: the force is the same everywhere. */
    @Override
    public boolean hasForceDerivatives() {
        return true;
    }

    @Override
    public void addForces(double[] state, double time, double[] force, int from, int to) {
        double[] masses = particles.masses();
        for (int i = from, f = STRIDE * from + 3; i < to; i++, f += STRIDE) {
            double mass = masses[i];
            force[f] += mass * gx;
            force[f + 1] += mass * gy;
            force[f + 2] += mass * gz;
        }
    }

    /** {@inheritDoc} Fixed particles, which nothing can bring down, are left out. */
    @Override
    public double getPotentialEnergy(double[] state, double time) {
        double energy = 0;
        for (int i = 0, x = 0; i < particles.count(); i++, x += STRIDE) {
            if (!particles.isFixed(i)) {
                energy -= particles.mass(i) * (gx * state[x] + gy * state[x + 1] + gz * state[x + 2]);
            }
        }
        return energy;
    }
}
