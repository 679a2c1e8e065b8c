package particles.effects;

import particles.law.Particles;
import particles.spec.Key;
import particles.spec.NumberType;
import particles.spec.Values;

/**
 * Linear (viscous) air drag, the slides' "particle-air damping": F = -c (v - u), where u is the velocity of the air.
 * The effect {@code wind} has no force of its own: it acts through drag, which can then drive particles. The base
 * class {@code AirDrag} computes v - u, the powers and the derivatives. As a {@link particles.law.PerParticleEffect} it
 * adds the forces on the particles {@code from} to {@code to - 1}: on all, or on the part of one thread.
 *
 * <p>Source: COMPSCI 715 (2003), slide "Damping (cont'd)", "particle-air damping".
 */
public final class LinearDrag extends AirDrag {
    /**
     * @param particles the particles in the air
     * @param c         the drag coefficient (N s/m), 0 or more
     * @param wind      the velocity field of the air
     * @throws IllegalArgumentException if c is negative or not finite
     */
    public LinearDrag(Particles particles, double c, Wind wind) {
        super(particles, c, 0, wind);
    }

    /** @return c (N s/m) */
    public double getCoefficient() {
        return c;
    }

    @Override
    public String getName() {
        return "drag";
    }

    @Override
    public void addForces(double[] state, double time, double[] force, int from, int to) {
        double[] w = velocityThroughAir(state, time, from, to);         // v - u of particle i in w[6 i + 3 ...]
        for (int k = 6 * from + 3; k < 6 * to; k += 6) {
            force[k] -= c * w[k];
            force[k + 1] -= c * w[k + 1];
            force[k + 2] -= c * w[k + 2];
        }
    }

    /** The keys of linear drag in scenes: {@code drag: {coefficient: 0.1}}. */
    public static final class Keys extends EffectKind {
        private static final Key<Double> COEFFICIENT = NumberType.notNegative("N s/m").required("coefficient",
                "c, the force per m/s of speed through the air (N s/m).");

        /** Called once, by {@link EffectCatalog}. */
        public Keys() {
            super("drag", "Air resistance proportional to the speed through the air.", COEFFICIENT);
        }

        @Override
        public void build(Values values, EffectContext scene) {
            scene.add(new LinearDrag(scene.particles(), values.get(COEFFICIENT), scene.wind()));
        }
    }
}
