package particles.effects;

import java.util.Optional;
import particles.LinearLaw;
import particles.Particles;

/**
 * Linear (viscous) air drag, the slides' "particle-air damping": F = -c (v - u), where u is the velocity of the air. Wind
 * acts through it and in no other way.
 *
 * <p>Source: COMPSCI 715 (2003), slide "Damping (cont'd)".
 */
public final class LinearDrag extends AirDrag {
    private final double coefficient;
    private final Optional<LinearLaw> linearLaw;

    /**
     * @param particles   on whom it acts
     * @param coefficient c (N s/m), 0 or more
     * @param wind        how the air moves
     * @throws IllegalArgumentException if c is negative or not finite
     */
    public LinearDrag(Particles particles, double coefficient, Wind wind) {
        super(particles, wind);
        requireCoefficient(coefficient);
        this.coefficient = coefficient;
        linearLaw = wind == Wind.STILL ? Optional.of(new LinearLaw(0, 0, 0, coefficient)) : Optional.empty();
    }

    /** @return c (N s/m) */
    public double getCoefficient() {
        return coefficient;
    }

    @Override
    public Optional<LinearLaw> getLinearLaw() {
        return linearLaw;
    }

    @Override
    public String getName() {
        return "drag";
    }

    @Override
    double coefficientAt(double speed) {
        return coefficient;
    }

    @Override
    double coefficientGrowth(double speed) {
        return 0;
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
}
