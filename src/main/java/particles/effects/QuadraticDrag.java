package particles.effects;

import particles.Particles;

/**
 * Quadratic air drag, that of things larger than dust and faster than a crawl: F = -c |v - u| (v - u), where u is the
 * velocity of the air and c = rho A C<sub>d</sub>/2, half the air's density times cross-section times drag coefficient.
 *
 * <p>From rest under gravity v = v<sub>t</sub> tanh(g t/v<sub>t</sub>) with the terminal speed v<sub>t</sub> = sqrt(m g/c).
 * The force's derivative is continuous at w = 0, its second derivative is not.
 */
public final class QuadraticDrag extends AirDrag {
    private final double coefficient;

    /**
     * @param particles   on whom it acts
     * @param coefficient c (N s&sup2;/m&sup2;, which is kg/m), 0 or more
     * @param wind        how the air moves
     * @throws IllegalArgumentException if c is negative or not finite
     */
    public QuadraticDrag(Particles particles, double coefficient, Wind wind) {
        super(particles, wind);
        requireCoefficient(coefficient);
        this.coefficient = coefficient;
    }

    @Override
    public String getName() {
        return "quadraticDrag";
    }

    @Override
    double coefficientAt(double speed) {
        return coefficient * speed;
    }

    @Override
    double coefficientGrowth(double speed) {
        return coefficient * speed;
    }

    @Override
    public void addForces(double[] state, double time, double[] force, int from, int to) {
        double[] air = airAt(state, time, from, to);
        for (int v = STRIDE * from + 3, u = 3 * from; v < STRIDE * to; v += STRIDE, u += 3) {
            double wx = state[v] - air[u];
            double wy = state[v + 1] - air[u + 1];
            double wz = state[v + 2] - air[u + 2];
            double c = coefficient * Math.sqrt(wx * wx + wy * wy + wz * wz);
            force[v] -= c * wx;
            force[v + 1] -= c * wy;
            force[v + 2] -= c * wz;
        }
    }
}
