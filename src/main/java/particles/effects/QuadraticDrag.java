package particles.effects;

import particles.law.Particles;
import particles.spec.Key;
import particles.spec.NumberType;
import particles.spec.Values;

/**
 * Quadratic air drag, as on a thrown ball: F = -c |v - u| (v - u), where u is the velocity of the air and c = rho A
 * C<sub>d</sub>/2, half the air's density times cross-section times drag coefficient.
 *
 * <p>From rest under gravity v = v<sub>t</sub> tanh(g t/v<sub>t</sub>) with the terminal speed v<sub>t</sub> = sqrt(m
 * g/c). The force's derivative is continuous at v = u, its second derivative is not.
 */
public final class QuadraticDrag extends AirDrag {
    /**
     * @param particles the particles in the air
     * @param c         the drag coefficient (N s&sup2;/m&sup2;, which is kg/m), 0 or more
     * @param wind      the velocity field of the air
     * @throws IllegalArgumentException if c is negative or not finite
     */
    public QuadraticDrag(Particles particles, double c, Wind wind) {
        super(particles, c, 1, wind);
    }

    @Override
    public String getName() {
        return "quadraticDrag";
    }

    @Override
    public void addForces(double[] state, double time, double[] force, int from, int to) {
        double[] w = velocityThroughAir(state, time, from, to);         // v - u
        for (int v = 6 * from + 3; v < 6 * to; v += 6) {
            double speed = Math.sqrt(w[v] * w[v] + w[v + 1] * w[v + 1] + w[v + 2] * w[v + 2]);
            force[v] -= c * speed * w[v];
            force[v + 1] -= c * speed * w[v + 1];
            force[v + 2] -= c * speed * w[v + 2];
        }
    }

    /** Quadratic drag in scenes. */
    public static final class Keys extends EffectKind {
        private static final Key<Double> COEFFICIENT = NumberType.notNegative("kg/m").required("coefficient",
                "c (kg/m): the force is c v^2, with v the speed through the air. c is half of air density times"
                + " cross-section times drag coefficient.");

        /** Called once, by {@link EffectCatalog}. */
        public Keys() {
            super("quadraticDrag", "Air resistance proportional to the square of the speed through the"
                    + " air.", COEFFICIENT);
        }

        @Override
        public void build(Values values, EffectContext scene) {
            scene.add(new QuadraticDrag(scene.particles(), values.get(COEFFICIENT), scene.wind()));
        }
    }
}
