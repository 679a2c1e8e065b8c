package particles.teaching.sources;

import deSolvers.problems.Kepler;
import particles.teaching.sources.StudentSource.SecondOrderSource;

/**
 * Two bodies that attract each other, x'' = -G m x/r^3, G m = 1 in all, on ellipses in an oblique plane.
 */
public final class Bodies extends StudentSource implements SecondOrderSource {
    private static final double[] MASSES = {0.4, 0.6};
    /** A turn of the plane of the orbit into space. */
    private static final double[][] AXES = {{0.48, 0.6, 0.64}, {-0.8, 0, 0.6}};

    private final Kepler orbit = new Kepler(0.3);

    /** Creates them at the shortest distance. */
    public Bodies() {
        super(new double[12]);
        startAt(0);
    }

    @Override
    public double[] exactState(double t) {
        double[] apart = orbit.exactState(t);
        double[] state = new double[12];
        for (int k = 0; k < 12; k++) {
            int kind = k / 3 % 2;
            double share = k < 6 ? -MASSES[1] : MASSES[0];
            state[k] = share * (apart[2 * kind] * AXES[0][k % 3] + apart[2 * kind + 1] * AXES[1][k % 3]);
        }
        return state;
    }

    @Override
    protected void rates(double t, double[] s, double[] dSdt) {
        double r2 = 0;
        for (int c = 0; c < 3; c++) {
            r2 += (s[6 + c] - s[c]) * (s[6 + c] - s[c]);
        }
        double r3 = r2 * Math.sqrt(r2);
        for (int k = 0; k < 12; k++) {
            int c = k % 3;
            dSdt[k] = k / 3 % 2 == 0 ? s[k + 3] : (k < 6 ? MASSES[1] : -MASSES[0]) * (s[6 + c] - s[c]) / r3;
        }
    }
}
