package deSolvers.problems;

import java.util.Arrays;

/**
 * A stiff, strongly damped chain: three masses of 1 kg on a line, each on a spring and a damper to the one before, the
 * first to a wall that moves as sin t. It follows the wall from the start, since every other motion decays at once. The
 * stiff springs do not show in the motion, but they limit the step of explicit solvers.
 *
 * <p>The shaken wall makes each spring the problem of A. Prothero and A. Robinson (Math. Comp. 28, 1974): a slow motion
 * that attracts all others. Implicit Runge-Kutta methods have only the order of their stages there, as long as deltaT
 * is much longer than 1/omega (E. Hairer and G. Wanner, Solving Ordinary Differential Equations II, section IV.15).
 */
public final class ShakenChain extends SecondOrderProblem {
    /** The springs are stiff for steps longer than this: ten times 1/omega of the slowest vibration, 1407/s. */
    public static final double STIFF_DELTA_T = 0.0071;

    private static final int MASSES = 3;
    private static final double STIFFNESS = 1e7;    // N/m
    private static final double DAMPING = 6e3;      // N s/m

    /** Creates the chain, on its steady swing. */
    public ShakenChain() {
        super(MASSES, new double[2 * MASSES]);
        startAt(0);
    }

    @Override
    protected void accelerate(double t, double[] s, double[] dSdt) {
        Arrays.fill(dSdt, MASSES, 2 * MASSES, 0);
        double before = StrictMath.sin(t);
        double beforeV = StrictMath.cos(t);
        for (int i = 0; i < MASSES; i++) {
            double force = STIFFNESS * (before - s[i]) + DAMPING * (beforeV - s[MASSES + i]);
            dSdt[MASSES + i] += force;
            if (i > 0) {
                dSdt[MASSES + i - 1] -= force;
            }
            before = s[i];
            beforeV = s[MASSES + i];
        }
    }

    /**
     * The steady swing x_i = Im(z_i e^(it)) with z_0 = 1, the wall. A spring pulls with G (z_(i-1) - z_i), G = k + i c,
     * and that moves all masses behind it: z_(i-1) = z_i - (z_i + ... + z_n) / G, from the free end to the wall; then
     * scaled.
     */
    @Override
    public double[] exactState(double t) {
        double[] re = new double[MASSES + 1];
        double[] im = new double[MASSES + 1];
        re[MASSES] = 1;
        double sumRe = 0;
        double sumIm = 0;
        double square = STIFFNESS * STIFFNESS + DAMPING * DAMPING;
        for (int i = MASSES; i > 0; i--) {
            sumRe += re[i];
            sumIm += im[i];
            re[i - 1] = re[i] - (sumRe * STIFFNESS + sumIm * DAMPING) / square;
            im[i - 1] = im[i] - (sumIm * STIFFNESS - sumRe * DAMPING) / square;
        }
        double scale = re[0] * re[0] + im[0] * im[0];
        double sin = StrictMath.sin(t);
        double cos = StrictMath.cos(t);
        double[] state = new double[2 * MASSES];
        for (int i = 0; i < MASSES; i++) {
            double a = (re[i + 1] * re[0] + im[i + 1] * im[0]) / scale;
            double b = (im[i + 1] * re[0] - re[i + 1] * im[0]) / scale;
            state[i] = a * sin + b * cos;
            state[MASSES + i] = a * cos - b * sin;
        }
        return state;
    }
}
