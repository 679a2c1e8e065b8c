package particles.teaching.sources;

import deSolvers.SecondOrderStateSource;
import java.util.Arrays;

/**
 * Particles on hardening springs, each coupled to the next, in a field that changes with time: x'' = -4 x - x^3 + (y -
 * x)/2 + f(t), y the same coordinate of the next particle. The field is chosen so that x = q (cos t + 0.5 cos 2t) is
 * the exact solution, with another q for each coordinate of each particle. A loose iteration, which solves a linear law
 * in one go, shows here.
 */
public final class NonlinearOscillators extends StudentSource implements SecondOrderStateSource {
    private static final double COUPLING = 0.5;

    /** @param particles the number of particles; six numbers each */
    public NonlinearOscillators(int particles) {
        super(exact(6 * particles, 0));
    }

    private static double amplitude(int k) {
        return 1 + 0.1 * (k % 3) + 0.07 * (k / 6);
    }

    private static double[] exact(int size, double t) {
        double[] exact = new double[size];
        double x = StrictMath.cos(t) + 0.5 * StrictMath.cos(2 * t);
        double v = -StrictMath.sin(t) - StrictMath.sin(2 * t);
        Arrays.setAll(exact, k -> amplitude(k) * (k % 6 < 3 ? x : v));
        return exact;
    }

    @Override
    public double[] exactState(double t) {
        return exact(getStateSize(), t);
    }

    @Override
    public int getDimension() {
        return 3;
    }

    @Override
    public boolean accelerationDependsOnVelocity() {
        return false;
    }

    @Override
    protected void rates(double t, double[] s, double[] dSdt) {
        double shape = StrictMath.cos(t) + 0.5 * StrictMath.cos(2 * t);
        double bent = -StrictMath.cos(t) - 2 * StrictMath.cos(2 * t);
        int size = Math.min(s.length, dSdt.length);
        for (int k = 0; k < size; k++) {
            if (k % 6 < 3) {
                dSdt[k] = s[k + 3];
                continue;
            }
            double q = amplitude(k);
            double x = s[k - 3];
            int next = (k + 3) % s.length;
            double field = q * bent + 4 * q * shape + q * q * q * shape * shape * shape
                    - COUPLING * (amplitude(next) - q) * shape;
            dSdt[k] = -4 * x - x * x * x + COUPLING * (s[next] - x) + field;
        }
    }
}
