package deSolvers.problems;

import java.util.Arrays;
import org.hipparchus.complex.Complex;

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
        Complex g = new Complex(STIFFNESS, DAMPING);
        Complex[] z = new Complex[MASSES + 1];
        z[MASSES] = Complex.ONE;
        Complex sum = Complex.ZERO;
        for (int i = MASSES; i > 0; i--) {
            sum = sum.add(z[i]);
            z[i - 1] = z[i].subtract(sum.divide(g));
        }
        Complex turn = new Complex(StrictMath.cos(t), StrictMath.sin(t)).divide(z[0]);
        double[] state = new double[2 * MASSES];
        for (int i = 0; i < MASSES; i++) {
            Complex swing = z[i + 1].multiply(turn);
            state[i] = swing.getImaginary();
            state[MASSES + i] = swing.getReal();        // the derivative of Im(z e^(it))
        }
        return state;
    }
}
