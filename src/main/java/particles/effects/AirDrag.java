package particles.effects;

import deSolvers.ForceDerivatives;
import java.util.Set;
import particles.law.BriefForce;
import particles.law.DifferentiableEffect;
import particles.law.Particles;
import particles.law.PerParticleEffect;
import particles.law.Require;
import particles.law.Vector3;
import particles.spec.Key;
import particles.spec.NumberType;
import particles.spec.Values;

/**
 * Air drag, the slides' "particle-air damping": the force F = -k w against the velocity w = v - u through the air,
 * where u is the velocity of the air. The effect {@code wind} has no force of its own: it acts through drag, which can
 * then drive particles. As a {@link particles.law.PerParticleEffect} it adds the forces on the particles {@code from}
 * to {@code to - 1}: on all, or on the part of one thread.
 * <pre>
 *   drag:           F = -c w
 *   quadraticDrag:  F = -c |w| w
 * </pre>
 * Linear (viscous) drag has k = c. Quadratic drag, as on a thrown ball, has k = c |w| with c = rho A
 * C<sub>d</sub>/2, half the air's density times cross-section times drag coefficient; from rest under gravity v =
 * v<sub>t</sub> tanh(g t/v<sub>t</sub>) with the terminal speed v<sub>t</sub> = sqrt(m g/c). Its derivative is
 * continuous at w = 0, its second derivative is not.
 *
 * <p>The power is -k |w|&sup2; - k w . u: the first term becomes heat, the second is work done by the wind. Source:
 * COMPSCI 715 (2003), slide "Damping (cont'd)", "particle-air damping".
 */
public final class AirDrag implements PerParticleEffect, DifferentiableEffect, BriefForce {
    private static final int STRIDE = Particles.STRIDE;

    private final Particles particles;
    private final double c;
    private final boolean quadratic;
    private final Wind wind;
    private double[] relative = {};
    private final double[] gradient = new double[9];
    private final double[] dFdX = new double[9];
    private final double[] dFdV = new double[9];

    private AirDrag(Particles particles, double c, boolean quadratic, Wind wind) {
        this.particles = particles;
        this.c = Require.notNegative("a drag coefficient", c);
        this.quadratic = quadratic;
        this.wind = wind;
    }

    /**
     * @param particles the particles in the air
     * @param c         the drag coefficient (N s/m), 0 or more
     * @param wind      the velocity field of the air
     * @return drag proportional to the speed
     * @throws IllegalArgumentException if c is negative or not finite
     */
    public static AirDrag linear(Particles particles, double c, Wind wind) {
        return new AirDrag(particles, c, false, wind);
    }

    /**
     * @param particles the particles in the air
     * @param c         the drag coefficient (N s&sup2;/m&sup2;, which is kg/m), 0 or more
     * @param wind      the velocity field of the air
     * @return drag proportional to the square of the speed
     * @throws IllegalArgumentException if c is negative or not finite
     */
    public static AirDrag quadratic(Particles particles, double c, Wind wind) {
        return new AirDrag(particles, c, true, wind);
    }

    @Override
    public String getName() {
        return quadratic ? "quadraticDrag" : "drag";
    }

    @Override
    public void addForces(double[] state, double time, double[] force, int from, int to) {
        double[] w = velocityThroughAir(state, time, from, to);         // v - u of particle i in w[6 i + 3 ...]
        for (int v = STRIDE * from + 3; v < STRIDE * to; v += STRIDE) {
            double k = coefficient(w, v);
            force[v] -= k * w[v];
            force[v + 1] -= k * w[v + 1];
            force[v + 2] -= k * w[v + 2];
        }
    }

    /** k of the particle whose velocity through the air begins at entry v (N s/m). */
    private double coefficient(double[] w, int v) {
        return quadratic ? c * Math.sqrt(w[v] * w[v] + w[v + 1] * w[v + 1] + w[v + 2] * w[v + 2]) : c;
    }

    /** @return the k of slow particles: c of linear drag (N s/m), 0 of quadratic drag */
    public double getSlowCoefficient() {
        return quadratic ? 0 : c;
    }

    /** {@inheritDoc} The period of the wind. */
    @Override
    public double getShortestTime(double[] state, double time) {
        return wind.getPeriod();
    }

    @Override
    public Set<Trait> getTraits() {
        return wind == Wind.STILL ? Set.of(Trait.DISSIPATIVE, Trait.ROTATION_INVARIANT, Trait.TRANSLATION_INVARIANT)
                : Set.of(Trait.DISSIPATIVE, Trait.DRIVING);
    }

    /** The velocity w = v - u of the particles from ... to - 1 through the air, in the entries of v. */
    private double[] velocityThroughAir(double[] state, double time, int from, int to) {
        if (wind == Wind.STILL) {
            return state;
        }
        double[] w = relative;
        if (w.length < STRIDE * particles.count()) {
            w = new double[STRIDE * particles.count()];
            relative = w;                               // concurrent threads each allocate their own
        }
        wind.getVelocities(state, time, w, from, to);
        for (int v = STRIDE * from + 3; v < STRIDE * to; v += STRIDE) {
            w[v] = state[v] - w[v];
            w[v + 1] = state[v + 1] - w[v + 1];
            w[v + 2] = state[v + 2] - w[v + 2];
        }
        return w;
    }

    @Override
    public double getDissipatedPower(double[] state, double time) {
        return sum(state, time, false);
    }

    @Override
    public double getDrivenPower(double[] state, double time) {
        return wind == Wind.STILL ? 0 : sum(state, time, true);
    }

    /** Sum over all free particles of k |w|&sup2; (dissipated) or -k w . u (driven). */
    private double sum(double[] state, double time, boolean driven) {
        double[] w = velocityThroughAir(state, time, 0, particles.count());
        return particles.sumOfFree(i -> {
            int v = STRIDE * i + 3;
            Vector3 through = Vector3.at(w, v);
            return coefficient(w, v) * (driven ? -through.dot(Vector3.at(state, v).minus(through))
                    : through.dot(through));
        });
    }

    /** {@inheritDoc} dF/dv = -k - k' w w<sup>T</sup>/|w|, and dF/dx = -dF/dv times the wind's gradient. */
    @Override
    public void addForceDerivatives(double[] state, double time, ForceDerivatives derivatives) {
        double[] w = velocityThroughAir(state, time, 0, particles.count());
        for (int i = 0; i < particles.count(); i++) {
            int v = STRIDE * i + 3;
            double square = w[v] * w[v] + w[v + 1] * w[v + 1] + w[v + 2] * w[v + 2];
            double k = coefficient(w, v);
            double growth = quadratic && square > 0 ? k / square : 0;
            for (int e = 0; e < 9; e++) {
                dFdV[e] = -(e % 4 == 0 ? k : 0) - growth * w[v + e / 3] * w[v + e % 3];
            }
            wind.getGradient(state, time, i, gradient);
            for (int e = 0; e < 9; e++) {
                int row = e - e % 3;
                dFdX[e] = -(dFdV[row] * gradient[e % 3] + dFdV[row + 1] * gradient[3 + e % 3]
                        + dFdV[row + 2] * gradient[6 + e % 3]);
            }
            derivatives.add(i, i, dFdX, dFdV);
        }
    }

    /** The keys of linear drag in scenes: {@code drag: {coefficient: 0.1}}. */
    public static final class LinearKeys extends EffectKind {
        private static final Key<Double> COEFFICIENT = NumberType.notNegative("N s/m").required("coefficient",
                "c, the force per m/s of speed through the air (N s/m).");

        /** Called once, by {@link EffectCatalog}. */
        public LinearKeys() {
            super("drag", "Air resistance proportional to the speed through the air.", COEFFICIENT);
        }

        @Override
        public void build(Values values, EffectContext scene) {
            scene.add(linear(scene.particles(), values.get(COEFFICIENT), scene.wind()));
        }
    }

    /** Quadratic drag in scenes. */
    public static final class QuadraticKeys extends EffectKind {
        private static final Key<Double> COEFFICIENT = NumberType.notNegative("kg/m").required("coefficient",
                "c (kg/m): the force is c v^2, with v the speed through the air. c is half of air density times"
                + " cross-section times drag coefficient.");

        /** Called once, by {@link EffectCatalog}. */
        public QuadraticKeys() {
            super("quadraticDrag", "Air resistance proportional to the square of the speed through the air.",
                    COEFFICIENT);
        }

        @Override
        public void build(Values values, EffectContext scene) {
            scene.add(quadratic(scene.particles(), values.get(COEFFICIENT), scene.wind()));
        }
    }
}
