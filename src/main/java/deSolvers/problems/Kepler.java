package deSolvers.problems;

/**
 * The Kepler problem: a planet on an ellipse of semi-major axis 1 and eccentricity e, with period 2 pi, from the
 * perihelion (G M = 1). The state is (x, y, v_x, v_y), one block of dimension 2. The exact solution comes from Kepler's
 * equation E - e sin E = t.
 */
public final class Kepler extends SecondOrderProblem {
    private final double e;

    /** @param eccentricity 0 to below 1 */
    public Kepler(double eccentricity) {
        super(2, new double[4]);
        this.e = eccentricity;
        startAt(0);
    }

    @Override
    public double[] exactState(double t) {
        double mean = StrictMath.IEEEremainder(t, 2 * Math.PI);
        double low = -Math.PI;
        double high = Math.PI;
        for (int i = 0; i < 60; i++) {                  // bisection, which cannot fail
            double middle = (low + high) / 2;
            if (middle - e * StrictMath.sin(middle) > mean) {
                high = middle;
            } else {
                low = middle;
            }
        }
        double c = StrictMath.cos(low);
        double s = StrictMath.sin(low);
        double b = Math.sqrt(1 - e * e);
        double rate = 1 / (1 - e * c);
        return new double[] {c - e, b * s, 0 - s * rate, b * c * rate};        // 0, not -0.0, at the perihelion
    }

    @Override
    protected void accelerate(double t, double[] s, double[] dSdt) {
        double r2 = s[0] * s[0] + s[1] * s[1];
        double r3 = r2 * Math.sqrt(r2);
        dSdt[2] = -s[0] / r3;
        dSdt[3] = -s[1] / r3;
    }

    @Override
    public boolean accelerationDependsOnVelocity() {
        return false;
    }
}
