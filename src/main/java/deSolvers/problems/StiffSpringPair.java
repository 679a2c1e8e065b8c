package deSolvers.problems;

/**
 * A stiff oscillator: two masses of 1/2 kg on a line, each on a soft spring of 1/2 N/m, with a stiff spring k between
 * them. Their centre swings with omega = 1 for any k. The stiff spring vibrates with omega = sqrt(1 + 4 k), at first
 * with a tiny amplitude.
 */
public final class StiffSpringPair extends SecondOrderProblem {
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
