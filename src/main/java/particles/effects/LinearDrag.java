package particles.effects;

import java.util.EnumSet;
import java.util.Set;
import particles.Effect;
import particles.ForceDerivatives;
import particles.Particles;

/**
 * Linear (viscous) air drag, the slides' "particle-air damping": F = -c (v - u), where u is the velocity of the air. Wind
 * acts through it and in no other way.
 *
 * <p>Its power F . v = -c |v - u|&sup2; - c (v - u) . u: the first part becomes heat, the second is what the wind does.
 * Source: COMPSCI 715 (2003), slide "Damping (cont'd)".
 */
public final class LinearDrag implements Effect {
    private static final int STRIDE = Particles.STRIDE;

    private final Particles particles;
    private final double coefficient;
    private final Wind wind;
    private double[] air = {};
    private final double[] dFdX = new double[9];        // stays 0
    private final double[] dFdV = new double[9];

    /**
     * @param particles   on whom it acts
     * @param coefficient c (N s/m), 0 or more
     * @param wind        how the air moves
     * @throws IllegalArgumentException if c is negative or not finite
     */
    public LinearDrag(Particles particles, double coefficient, Wind wind) {
        if (!(coefficient >= 0) || !(coefficient <= Double.MAX_VALUE)) {
            throw new IllegalArgumentException("a drag coefficient has to be 0 or more and finite, not " + coefficient);
        }
        this.particles = particles;
        this.coefficient = coefficient;
        this.wind = wind;
        for (int e = 0; e < 9; e += 4) {
            dFdV[e] = -coefficient;
        }
    }

    /** @return c (N s/m) */
    public double getCoefficient() {
        return coefficient;
    }

    @Override
    public String getName() {
        return "drag";
    }

    @Override
    public Set<Trait> getTraits() {
        return wind == Wind.STILL ? EnumSet.of(Trait.DISSIPATIVE, Trait.ROTATION_INVARIANT, Trait.TRANSLATION_INVARIANT)
                : EnumSet.of(Trait.DISSIPATIVE, Trait.DRIVING);
    }

    @Override
    public int size() {
        return particles.count();
    }

    @Override
    public boolean dependsOnVelocity() {
        return true;
    }

    /** {@inheritDoc} They are known where the air moves in the same way everywhere. */
    @Override
    public boolean hasForceDerivatives() {
        return wind == Wind.STILL || wind.isUniform();
    }

    @Override
    public void addForceDerivatives(double[] state, double time, ForceDerivatives derivatives) {
        for (int i = 0; i < particles.count(); i++) {
            derivatives.add(i, i, dFdX, dFdV);
        }
    }

    @Override
    public void addForces(double[] state, double time, double[] force, int from, int to) {
        double c = coefficient;
        if (wind == Wind.STILL) {
            for (int v = STRIDE * from + 3; v < STRIDE * to; v += STRIDE) {
                force[v] -= c * state[v];
                force[v + 1] -= c * state[v + 1];
                force[v + 2] -= c * state[v + 2];
            }
            return;
        }
        double[] air = airAt(state, time, from, to);
        for (int v = STRIDE * from + 3, u = 3 * from; v < STRIDE * to; v += STRIDE, u += 3) {
            force[v] -= c * (state[v] - air[u]);
            force[v + 1] -= c * (state[v + 1] - air[u + 1]);
            force[v + 2] -= c * (state[v + 2] - air[u + 2]);
        }
    }

    private double[] airAt(double[] state, double time, int from, int to) {
        if (air.length < 3 * particles.count()) {
            air = new double[3 * particles.count()];
        }
        wind.getVelocities(state, time, air, from, to);
        return air;
    }

    @Override
    public double getDissipatedPower(double[] state, double time) {
        return sum(state, time, false);
    }

    @Override
    public double getDrivenPower(double[] state, double time) {
        return wind == Wind.STILL ? 0 : sum(state, time, true);
    }

    /** Of all particles that are not fixed: c |v - u|&sup2;, or -c (v - u) . u. */
    private double sum(double[] state, double time, boolean driven) {
        double[] air = airAt(state, time, 0, particles.count());
        double sum = 0;
        for (int i = 0; i < particles.count(); i++) {
            if (particles.isFixed(i)) {
                continue;
            }
            for (int c = 0; c < 3; c++) {
                double u = air[3 * i + c];
                double relative = state[STRIDE * i + 3 + c] - u;
                sum += driven ? -relative * u : relative * relative;
            }
        }
        return coefficient * sum;
    }
}
