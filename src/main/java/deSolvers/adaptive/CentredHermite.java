package deSolvers.adaptive;

/**
 * The polynomial P(u) of degree m + 4, u from -1/2 to 1/2, that has given states and derivatives at both ends of a
 * sub-step and m + 1 given Taylor coefficients at its middle. Its even and odd powers are found apart: each half has two
 * powers left and two conditions.
 */
public final class CentredHermite {
    private CentredHermite() {
    }

    /**
     * Adds the four highest powers.
     *
     * @param c        c[0] ... c[m] are the coefficients at the middle, h<sup>k</sup>/k! times the k-th derivative;
     *                 c[m + 1] ... c[m + 4] are written
     * @param m        the highest power given; -1 for none, which makes the cubic Hermite polynomial
     * @param state    the state at the beginning
     * @param slope    the derivative there
     * @param newState the state at the end
     * @param newSlope the derivative there
     * @param h        the length of the sub-step (s)
     */
    public static void complete(double[][] c, int m, double[] state, double[] slope, double[] newState, double[] newSlope,
                                double h) {
        for (int i = 0; i < state.length; i++) {
            double evenValue = (newState[i] + state[i]) / 2;
            double evenRate = h * (newSlope[i] - slope[i]) / 2;
            double oddValue = (newState[i] - state[i]) / 2;
            double oddRate = h * (newSlope[i] + slope[i]) / 2;
            double power = 1;                           // (1/2)^k
            for (int k = 0; k <= m; k++) {
                double known = c[k][i] * power;
                if (k % 2 == 0) {
                    evenValue -= known;
                    evenRate -= 2 * k * known;
                } else {
                    oddValue -= known;
                    oddRate -= 2 * k * known;
                }
                power /= 2;
            }
            int lowest = m + 1;
            boolean evenFirst = lowest % 2 == 0;
            twoPowers(c, i, lowest, power, evenFirst ? evenValue : oddValue, evenFirst ? evenRate : oddRate);
            twoPowers(c, i, lowest + 1, power / 2, evenFirst ? oddValue : evenValue, evenFirst ? oddRate : evenRate);
        }
    }

    /** a u^p + b u^(p+2) with the given value and rate at u = 1/2, where u^p = power. */
    private static void twoPowers(double[][] c, int i, int p, double power, double value, double rate) {
        double upper = (rate - 2 * p * value) / 4;
        c[p][i] = (value - upper) / power;
        c[p + 2][i] = upper / (power / 4);
    }
}
