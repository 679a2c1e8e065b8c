package deSolvers.problems;

import deSolvers.SecondOrderStateSource;
import java.util.Arrays;
import org.hipparchus.complex.Complex;
import org.hipparchus.special.elliptic.jacobi.CopolarN;
import org.hipparchus.special.elliptic.jacobi.JacobiEllipticBuilder;
import org.hipparchus.special.elliptic.legendre.LegendreEllipticIntegral;

/** A reference problem x'' = a(x, v, t) in blocks of d positions and d velocities. */
public abstract class SecondOrderProblem extends ReferenceProblem implements SecondOrderStateSource {
    private final int d;

    /**
     * @param d     the number of positions in a block
     * @param start the state at t = 0, whole blocks; a copy is taken
     */
    protected SecondOrderProblem(int d, double... start) {
        super(start);
        this.d = d;
    }

    /**
     * Writes the acceleration into the velocity entries of the derivative.
     *
     * @param t    the time (s)
     * @param s    the state; to be read only
     * @param dSdt receives the acceleration
     */
    protected abstract void accelerate(double t, double[] s, double[] dSdt);

    @Override
    protected final void rates(double t, double[] s, double[] dSdt) {
        for (int x = 0; x < s.length; x += 2 * d) {
            System.arraycopy(s, x + d, dSdt, x, d);
        }
        accelerate(t, s, dSdt);
    }

    @Override
    public final int getDimension() {
        return d;
    }

    /** A pendulum, theta'' = -sin theta, released at rest. */
    public static final class Pendulum extends SecondOrderProblem {
        /** Nearer to pi, round-off decides when it falls. */
        private static final double LARGEST = 3.14;

        private final double release;

        /**
         * @param release the angle at t = 0 (rad)
         * @throws IllegalArgumentException if it is larger than 3.14, where it hardly begins to fall
         */
        public Pendulum(double release) {
            super(1, release, 0);
            if (!(Math.abs(release) <= LARGEST)) {
                throw new IllegalArgumentException("a release at " + release + " rad; at most " + LARGEST);
            }
            this.release = release;
        }

        @Override
        protected void accelerate(double t, double[] s, double[] dSdt) {
            dSdt[1] = -StrictMath.sin(s[0]);
        }

        @Override
        public boolean accelerationDependsOnVelocity() {
            return false;
        }

        /** sin(theta/2) = k sn(K + t, k) with k = sin(release/2): Jacobi's elliptic function, at rest at t = 0. */
        @Override
        public double[] exactState(double t) {
            double k = StrictMath.sin(release / 2);
            CopolarN elliptic = JacobiEllipticBuilder.build(k * k).valuesN(LegendreEllipticIntegral.bigK(k * k) + t);
            return new double[] {2 * StrictMath.asin(k * elliptic.sn()), 2 * k * elliptic.cn()};
        }
    }

    /**
     * The Kepler problem: a planet on an ellipse of semi-major axis 1 and eccentricity e, with period 2 pi, from the
     * perihelion (G M = 1). The state is (x, y, v_x, v_y), one block of dimension 2. The exact solution comes from
     * Kepler's equation E - e sin E = t.
     */
    public static final class Kepler extends SecondOrderProblem {
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

    /**
     * A stiff oscillator: two masses of 1/2 kg on a line, each on a soft spring of 1/2 N/m, with a stiff spring k
     * between them. Their centre swings with omega = 1 for any k. The stiff spring vibrates with omega = sqrt(1 + 4 k),
     * at first with a tiny amplitude.
     */
    public static final class StiffSpringPair extends SecondOrderProblem {
        /** The amplitude of the stiff vibration at the start: far below 1 %, far above rounding (m). */
        public static final double SEED = 1e-6;

        private final double stiffness;

        /** @param stiffness k of the spring between the masses (N/m) */
        public StiffSpringPair(double stiffness) {
            super(2, 1 - SEED, 1 + SEED, 0, 0);
            this.stiffness = stiffness;
        }

        @Override
        protected void accelerate(double t, double[] s, double[] dSdt) {
            double pull = 2 * stiffness * (s[1] - s[0]);
            dSdt[2] = -s[0] + pull;
            dSdt[3] = -s[1] - pull;
        }

        @Override
        public boolean accelerationDependsOnVelocity() {
            return false;
        }

        /** @return the angular frequency of the stiff vibration (1/s) */
        public double omega() {
            return Math.sqrt(1 + 4 * stiffness);
        }

        /** @return the position of the centre (m); cos t in the exact solution */
        public double centre() {
            double[] s = getState();
            return (s[0] + s[1]) / 2;
        }

        /** @return the energy of the stiff vibration divided by that at the start */
        public double vibration() {
            double[] s = getState();
            double x = (s[1] - s[0]) / 2;
            double v = (s[3] - s[2]) / 2 / omega();
            return (x * x + v * v) / (SEED * SEED);
        }
    }

    /**
     * A stiff, strongly damped chain: three masses of 1 kg on a line, each on a spring and a damper to the one before,
     * the first to a wall that moves as sin t. It follows the wall from the start, since every other motion decays at
     * once. The stiff springs do not show in the motion, but they limit the step of explicit solvers.
     *
     * <p>The shaken wall makes each spring the problem of A. Prothero and A. Robinson (Math. Comp. 28, 1974): a slow
     * motion that attracts all others. Implicit Runge-Kutta methods have only the order of their stages there, as long
     * as deltaT is much longer than 1/omega (E. Hairer and G. Wanner, Solving Ordinary Differential Equations II,
     * section IV.15).
     */
    public static final class ShakenChain extends SecondOrderProblem {
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
         * The steady swing x_i = Im(z_i e^(it)) with z_0 = 1, the wall. A spring pulls with G (z_(i-1) - z_i), G = k +
         * i c, and that moves all masses behind it: z_(i-1) = z_i - (z_i + ... + z_n) / G, from the free end to the
         * wall; then scaled.
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
}
