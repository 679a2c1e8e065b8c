package particles.effects;

import deSolvers.ForceDerivatives;
import java.util.Set;
import particles.law.DifferentiableEffect;
import particles.law.Particles;
import particles.law.PerParticleEffect;
import particles.law.Require;

/**
 * Base class for air drag: the force -k w against the velocity w = v - u through the air, with k = c or c |w|. Its
 * power is -k |w|&sup2; - k w . u: the first term becomes heat, the second is work done by the wind.
 */
abstract class AirDrag implements PerParticleEffect, DifferentiableEffect {
    private static final int STRIDE = Particles.STRIDE;

    private final Particles particles;
    final double c;
    private final int exponent;
    private final Wind wind;
    private double[] relative = {};
    private final double[] w = new double[3];
    private final double[] gradient = new double[9];
    private final double[] dFdX = new double[9];
    private final double[] dFdV = new double[9];

    /** @param exponent k is c times this power of the speed, 0 or 1 */
    AirDrag(Particles particles, double c, int exponent, Wind wind) {
        this.particles = particles;
        this.c = Require.notNegative("a drag coefficient", c);
        this.exponent = exponent;
        this.wind = wind;
    }

    /** k at a speed through the air (N s/m). */
    private double coefficientAt(double speed) {
        return exponent == 0 ? c : c * speed;
    }

    @Override
    public final Set<Trait> getTraits() {
        return wind == Wind.STILL ? Set.of(Trait.DISSIPATIVE, Trait.ROTATION_INVARIANT, Trait.TRANSLATION_INVARIANT)
                : Set.of(Trait.DISSIPATIVE, Trait.DRIVING);
    }

    /** The velocity w = v - u of the particles from ... to - 1 through the air, in the entries of v. */
    final double[] velocityThroughAir(double[] state, double time, int from, int to) {
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
    public final double getDissipatedPower(double[] state, double time) {
        return sum(state, time, false);
    }

    @Override
    public final double getDrivenPower(double[] state, double time) {
        return wind == Wind.STILL ? 0 : sum(state, time, true);
    }

    /** Sum over all free particles of k |w|&sup2; (dissipated) or -k w . u (driven). */
    private double sum(double[] state, double time, boolean driven) {
        double[] w = velocityThroughAir(state, time, 0, particles.count());
        double sum = 0;
        for (int i = 0; i < particles.count(); i++) {
            if (!particles.isFixed(i)) {
                double square = 0;
                double against = 0;
                for (int v = STRIDE * i + 3; v < STRIDE * i + 6; v++) {
                    square += w[v] * w[v];
                    against -= w[v] * (state[v] - w[v]);
                }
                sum += coefficientAt(Math.sqrt(square)) * (driven ? against : square);
            }
        }
        return sum;
    }

    /** {@inheritDoc} dF/dv = -k - k' w w<sup>T</sup>/|w|, and dF/dx = -dF/dv times the wind's gradient. */
    @Override
    public final void addForceDerivatives(double[] state, double time, ForceDerivatives derivatives) {
        double[] through = velocityThroughAir(state, time, 0, particles.count());
        for (int i = 0; i < particles.count(); i++) {
            System.arraycopy(through, STRIDE * i + 3, w, 0, 3);
            double square = w[0] * w[0] + w[1] * w[1] + w[2] * w[2];
            double speed = Math.sqrt(square);
            double growth = square > 0 ? exponent * coefficientAt(speed) / square : 0;
            for (int e = 0; e < 9; e++) {
                dFdV[e] = -(e % 4 == 0 ? coefficientAt(speed) : 0) - growth * w[e / 3] * w[e % 3];
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
}
