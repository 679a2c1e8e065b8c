package particles.effects;

import java.util.EnumSet;
import java.util.Set;
import particles.Effect;
import particles.ForceDerivatives;
import particles.Particles;

/**
 * What all laws of air drag have in common: the force -c(|w|) w against the velocity w = v - u through the air. Its power is
 * -c |w|&sup2; - c w . u: the first part becomes heat, the second is what the wind does.
 */
abstract class AirDrag implements Effect {
    static final int STRIDE = Particles.STRIDE;

    final Particles particles;
    final Wind wind;
    private double[] air = {};
    private final double[] w = new double[3];
    private final double[] gradient = new double[9];
    private final double[] dFdX = new double[9];        // stays 0 in wind that is the same everywhere
    private final double[] dFdV = new double[9];

    AirDrag(Particles particles, Wind wind) {
        this.particles = particles;
        this.wind = wind;
    }

    /** c at a speed through the air (N s/m). */
    abstract double coefficientAt(double speed);

    /** |w| dc/d|w|, 0 for a coefficient that does not depend on the speed (N s/m). */
    abstract double coefficientGrowth(double speed);

    @Override
    public final Set<Trait> getTraits() {
        return wind == Wind.STILL ? EnumSet.of(Trait.DISSIPATIVE, Trait.ROTATION_INVARIANT, Trait.TRANSLATION_INVARIANT)
                : EnumSet.of(Trait.DISSIPATIVE, Trait.DRIVING);
    }

    @Override
    public final int size() {
        return particles.count();
    }

    @Override
    public final boolean isPerParticle() {
        return true;
    }

    @Override
    public final boolean isConcurrent() {
        return true;
    }

    @Override
    public final boolean dependsOnVelocity() {
        return true;
    }

    /** The air's velocity at the particles from ... to - 1, three entries each; all others are of no meaning. */
    final double[] airAt(double[] state, double time, int from, int to) {
        double[] velocities = air;
        if (velocities.length < 3 * particles.count()) {
            velocities = new double[3 * particles.count()];
            air = velocities;                           // of several threads at once, each goes on with its own, and one stays
        }
        wind.getVelocities(state, time, velocities, from, to);
        return velocities;
    }

    @Override
    public final double getDissipatedPower(double[] state, double time) {
        return sum(state, time, false);
    }

    @Override
    public final double getDrivenPower(double[] state, double time) {
        return wind == Wind.STILL ? 0 : sum(state, time, true);
    }

    /** Of all particles that are not fixed: c |w|&sup2;, or -c w . u. */
    private double sum(double[] state, double time, boolean driven) {
        double[] air = airAt(state, time, 0, particles.count());
        double sum = 0;
        for (int i = 0; i < particles.count(); i++) {
            if (particles.isFixed(i)) {
                continue;
            }
            double square = 0;
            double against = 0;
            for (int c = 0; c < 3; c++) {
                double u = air[3 * i + c];
                double w = state[STRIDE * i + 3 + c] - u;
                square += w * w;
                against -= w * u;
            }
            sum += coefficientAt(Math.sqrt(square)) * (driven ? against : square);
        }
        return sum;
    }

    /** {@inheritDoc} They are known where the wind's own derivatives are. */
    @Override
    public final boolean hasForceDerivatives() {
        return wind == Wind.STILL || wind.hasGradient();
    }

    /** {@inheritDoc} dF/dv = -c - c' w w<sup>T</sup>/|w|, and dF/dx = -dF/dv times the wind's gradient. */
    @Override
    public final void addForceDerivatives(double[] state, double time, ForceDerivatives derivatives) {
        double[] air = airAt(state, time, 0, particles.count());
        boolean varies = wind != Wind.STILL && !wind.isUniform();
        for (int i = 0; i < particles.count(); i++) {
            for (int c = 0; c < 3; c++) {
                w[c] = state[STRIDE * i + 3 + c] - air[3 * i + c];
            }
            double square = w[0] * w[0] + w[1] * w[1] + w[2] * w[2];
            double speed = Math.sqrt(square);
            double growth = square > 0 ? coefficientGrowth(speed) / square : 0;
            for (int e = 0; e < 9; e++) {
                dFdV[e] = -(e % 4 == 0 ? coefficientAt(speed) : 0) - growth * w[e / 3] * w[e % 3];
            }
            if (varies) {
                wind.getGradient(state, time, i, gradient);
                for (int e = 0; e < 9; e++) {
                    int row = e - e % 3;
                    dFdX[e] = -(dFdV[row] * gradient[e % 3] + dFdV[row + 1] * gradient[3 + e % 3]
                            + dFdV[row + 2] * gradient[6 + e % 3]);
                }
            }
            derivatives.add(i, i, dFdX, dFdV);
        }
    }

    static void requireCoefficient(double coefficient) {
        if (!(coefficient >= 0) || !(coefficient <= Double.MAX_VALUE)) {
            throw new IllegalArgumentException("a drag coefficient has to be 0 or more and finite, not " + coefficient);
        }
    }
}
