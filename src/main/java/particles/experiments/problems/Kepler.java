package particles.experiments.problems;

/** A planet around a sun of mass 1 at the origin: semi-major axis 1, period 2 pi, from the perihelion. */
final class Kepler extends TestProblem {
    Kepler(double eccentricity) {
        super(1 - eccentricity, 0, 0, Math.sqrt((1 + eccentricity) / (1 - eccentricity)));
    }

    @Override
    protected void accelerate(double[] s, double[] dSdt) {
        double square = s[0] * s[0] + s[1] * s[1];
        double cube = square * Math.sqrt(square);
        dSdt[2] = -s[0] / cube;
        dSdt[3] = -s[1] / cube;
    }

    /** By Kepler's equation E - e sin E = t, solved by bisection, which cannot fail. */
    static double[] exactState(double e, double t) {
        double mean = StrictMath.IEEEremainder(t, 2 * Math.PI);
        double low = -Math.PI;
        double high = Math.PI;
        for (int k = 0; k < 60; k++) {
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
        return new double[] {c - e, b * s, -s * rate, b * c * rate};
    }
}
