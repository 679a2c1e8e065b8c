package deSolvers.problems;

/** Equations of first order whose solutions are known. */
public final class KnownSolutions {
    /** The time, besides 0, at which the solution of {@link #vanDerPol} is known (s). */
    public static final double END_OF_VAN_DER_POL = 2;
    /** The time, besides 0, at which the solution of {@link #robertson} is known (s). */
    public static final double END_OF_ROBERTSON = 40;

    private KnownSolutions() {
    }

    /**
     * s' = -rate s from 1.
     *
     * @param rate how fast it decays (1/s)
     */
    public static Law decay(double rate) {
        return new Law((t, s, dSdt) -> dSdt[0] = -rate * s[0], t -> new double[] {StrictMath.exp(-rate * t)});
    }

    /**
     * s' = lambda s from 1 with lambda = re + i im, as a system of two.
     *
     * @param re real part of lambda (1/s)
     * @param im its imaginary part (1/s)
     */
    public static Law testEquation(double re, double im) {
        return new Law((t, s, dSdt) -> {
            dSdt[0] = re * s[0] - im * s[1];
            dSdt[1] = im * s[0] + re * s[1];
        }, t -> {
            double size = StrictMath.exp(re * t);
            return new double[] {size * StrictMath.cos(im * t), size * StrictMath.sin(im * t)};
        });
    }

    /**
     * s' = s cos t, s(0) = 1: s = exp(sin t). Its derivative depends on time, so a wrong stage time shows: a
     * Runge-Kutta method that moves the clock only at the end has order 1 here and full order on the oscillator.
     */
    public static Law growthInSeason() {
        return new Law((t, s, dSdt) -> dSdt[0] = s[0] * StrictMath.cos(t),
                t -> new double[] {StrictMath.exp(StrictMath.sin(t))});
    }

    /** y' = y^2, y(0) = 1: y = 1/(1 - t), which has a pole at t = 1. */
    public static Law pole() {
        return new Law((t, s, dSdt) -> dSdt[0] = s[0] * s[0], t -> new double[] {1 / (1 - t)});
    }

    /**
     * x'' = -x from (1, 0), and beside it x'' = -omega^2 x - 2 gamma x' from (0.5, 0).
     *
     * @param omega angular frequency of the fast spring without damping (1/s)
     * @param gamma its damping, less than omega (1/s)
     */
    public static Law slowAndFastSpring(double omega, double gamma) {
        double damped = Math.sqrt(omega * omega - gamma * gamma);
        return new Law((t, s, dSdt) -> {
            dSdt[0] = s[1];
            dSdt[1] = -s[0];
            dSdt[2] = s[3];
            dSdt[3] = -omega * omega * s[2] - 2 * gamma * s[3];
        }, t -> {
            double c = 0.5 * StrictMath.exp(-gamma * t) * StrictMath.cos(damped * t);
            double s = 0.5 * StrictMath.exp(-gamma * t) * StrictMath.sin(damped * t);
            return new double[] {StrictMath.cos(t), -StrictMath.sin(t), c + gamma / damped * s,
                -omega * omega / damped * s};
        });
    }

    /** u' = 998 u + 1998 v, v' = -999 u - 1999 v from (1, 0): u = 2 e^-t - e^-1000t, v = -e^-t + e^-1000t. */
    public static Law stiffPair() {
        return new Law((t, s, dSdt) -> {
            dSdt[0] = 998 * s[0] + 1998 * s[1];
            dSdt[1] = -999 * s[0] - 1999 * s[1];
        }, t -> {
            double slow = StrictMath.exp(-t);
            double fast = StrictMath.exp(-1000 * t);
            return new double[] {2 * slow - fast, -slow + fast};
        });
    }

    /**
     * y' = L (y - cos t) - sin t, y(0) = 1: y = cos t for every L. The stiffer L is, the more a method's order on this
     * problem falls from its classical order towards the order of its stages.
     *
     * <p>Source: A. Prothero, A. Robinson (1974), Math. Comp. 28, 145.
     *
     * @param lambda L (1/s), negative and large for a stiff problem
     */
    public static Law protheroRobinson(double lambda) {
        return new Law((t, s, dSdt) -> dSdt[0] = lambda * (s[0] - StrictMath.cos(t)) - StrictMath.sin(t),
                t -> new double[] {StrictMath.cos(t)});
    }

    /**
     * Van der Pol's oscillator, eps y'' = (1 - y^2) y' - y with eps = 1e-6, from (2, 0) to t = 2: two slow stretches
     * and the jump between them.
     */
    public static Law vanDerPol() {
        return new Law((t, s, dSdt) -> {
            dSdt[0] = s[1];
            dSdt[1] = ((1 - s[0] * s[0]) * s[1] - s[0]) / 1e-6;
        }, t -> t == 0 ? new double[] {2, 0} : new double[] {1.706167732170483, -0.8928097010247975});
    }

    /**
     * Robertson's chemical reactions from (1, 0, 0), to t = 40: rate constants from 0.04 to 3e7. The state at the end
     * agrees with the ten digits of E. Hairer and G. Wanner, <i>Solving Ordinary Differential Equations II</i>; the
     * others are from Taylor series of degree 36 in numbers of 40 digits, 7,745 steps with a remainder of 1e-28 each.
     */
    public static Law robertson() {
        return new Law((t, s, dSdt) -> {
            double slow = 0.04 * s[0];
            double back = 1e4 * s[1] * s[2];
            double fast = 3e7 * s[1] * s[1];
            dSdt[0] = -slow + back;
            dSdt[1] = slow - back - fast;
            dSdt[2] = fast;
        }, t -> t == 0 ? new double[] {1, 0, 0}
                : new double[] {0.7158270687194050905, 9.185534764557763904e-6, 0.2841637457458303518});
    }
}
